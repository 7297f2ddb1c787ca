// point_walk.glsl in CUDA: a thread gathers one point. Compiled with -fmad=false, so that its sums
// equal the twin's bits.
#include <cuda_runtime.h>

#include "cuda/point_walk.hpp"

namespace sfumato::bench {
namespace {

struct vec2 {
  float x, y;
  __device__ vec2() {}
  __device__ vec2(float a, float b) : x(a), y(b) {}
};
struct vec4 {
  float x, y, z, w;
  __device__ vec4() {}
  __device__ vec4(float a, float b, float c, float d) : x(a), y(b), z(c), w(d) {}
};
using ivec4 = int4;

__device__ float intBitsToFloat(int bits) {
  return __int_as_float(bits);
}
__device__ int floatBitsToInt(float number) {
  return __float_as_int(number);
}
__device__ float uintBitsToFloat(unsigned int bits) {
  return __uint_as_float(bits);
}
__device__ unsigned int floatBitsToUint(float number) {
  return __float_as_uint(number);
}
__device__ float min(float a, float b) {
  return b < a ? b : a;
}
__device__ float max(float a, float b) {
  return a < b ? b : a;
}
__device__ float abs(float a) {
  return fabsf(a);
}

struct Walk {
  const int4* edge_beyond;
  const int4* hit_edge;
  const int4* scene_triangle;

  __device__ ivec4 beyond_at(int i) const { return __ldg(edge_beyond + i); }
  __device__ ivec4 hit_at(int i) const { return __ldg(hit_edge + i); }
  __device__ ivec4 triangle_at(int i) const { return __ldg(scene_triangle + i); }

#define FN __device__
#define P
#define STACK 16
#define BLEND 0
#include "gather/point_walk.glsl"
};

struct Point {
  float x, y;
  int triangle;
};

__global__ void gather_points(Walk walk, const Point* point, int count, float negligible,
                              float* sums) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i >= count) return;
  walk.gather(vec2(point[i].x, point[i].y), point[i].triangle, negligible, 1 << 17);
  float* const row = sums + 5 * i;
  row[0] = walk.failed ? -1.0f : walk.weight;
  row[1] = walk.value.x, row[2] = walk.value.y, row[3] = walk.value.z, row[4] = walk.value.w;
}

/// Memory on the device.
class DeviceTable {
 public:
  explicit DeviceTable(std::size_t bytes, const void* content = nullptr) {
    if (cudaMalloc(&at_, bytes + 16) != cudaSuccess) at_ = nullptr;
    if (at_ && content) cudaMemcpy(at_, content, bytes, cudaMemcpyHostToDevice);
  }
  ~DeviceTable() { cudaFree(at_); }
  DeviceTable(const DeviceTable&) = delete;
  DeviceTable& operator=(const DeviceTable&) = delete;

  template <class Row>
  Row* rows() const {
    return static_cast<Row*>(at_);
  }

 private:
  void* at_ = nullptr;
};

}  // namespace

double walk_by_cuda(const CudaWalk& walk, int times, float* sums, std::string& device_or_error) {
  cudaDeviceProp device;
  cudaError_t error = cudaGetDeviceProperties(&device, 0);
  device_or_error = error == cudaSuccess ? device.name : cudaGetErrorString(error);
  if (error != cudaSuccess) return -1;
  const DeviceTable beyond(walk.edge_beyond_bytes, walk.edge_beyond);
  const DeviceTable hit(walk.hit_edge_bytes, walk.hit_edge);
  const DeviceTable triangle(walk.triangle_bytes, walk.triangle);
  const DeviceTable point(walk.point_count * sizeof(Point), walk.point);
  const std::size_t sum_bytes = walk.point_count * 5 * sizeof(float);
  const DeviceTable sum(sum_bytes);
  const Walk tables{beyond.rows<int4>(), hit.rows<int4>(), triangle.rows<int4>()};
  const int count = static_cast<int>(walk.point_count);
  const int blocks = (count + walk.block_size - 1) / walk.block_size;
  const auto run = [&] {
    gather_points<<<blocks, walk.block_size>>>(tables, point.rows<Point>(), count, walk.negligible,
                                               sum.rows<float>());
  };
  cudaEvent_t begin, end;
  cudaEventCreate(&begin), cudaEventCreate(&end);
  run();
  cudaEventRecord(begin);
  for (int i = 0; i < times; ++i) run();
  cudaEventRecord(end);
  cudaEventSynchronize(end);
  float milliseconds = 0;
  cudaEventElapsedTime(&milliseconds, begin, end);
  cudaEventDestroy(begin), cudaEventDestroy(end);
  error = cudaMemcpy(sums, sum.rows<float>(), sum_bytes, cudaMemcpyDeviceToHost);
  if (error == cudaSuccess) error = cudaGetLastError();
  if (error == cudaSuccess) return milliseconds / times;
  device_or_error = cudaGetErrorString(error);
  return -1;
}

}  // namespace sfumato::bench
