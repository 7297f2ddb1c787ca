#include "gpu/walker.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/charge.hpp"
#include "base/stopwatch.hpp"
#include "base/try.hpp"
#include "gather/kernels/negligible.hpp"

namespace sfumato::gpu {
namespace {

/// The CPU does walks of more steps than this; 2,000 specks may take 90,000.
constexpr GLint kStepLimit = 1 << 17;

constexpr std::size_t kFirstBatch = 256, kLargestBatch = std::size_t{1} << 16;
constexpr double kBatchSeconds = 0.02;
constexpr std::size_t kScenes = 4;  ///< scenes whose tables stay on the device

Status lost(const Device& device) {
  return make_error(StatusCode::unavailable,
                    "no GPU can be used: " + device.name() + " does not answer any more");
}

}  // namespace

Result<std::unique_ptr<Walker>> Walker::create(const WalkShape& shape, const WalkLimits& limits) {
  SFUMATO_TRY_ASSIGN(auto&& device, Device::create(DeviceUse::compute));
  std::unique_ptr<Walker> walker(new Walker(std::move(device), shape));
  SFUMATO_TRY(walker->read_limits(limits));
  return walker;
}

Walker::Walker(std::unique_ptr<Device> device, const WalkShape& shape)
    : device_(std::move(device)),
      shape_(shape),
      batch_(kFirstBatch),
      point_buffer_(make_buffer()),
      result_buffer_(make_buffer()) {}

Status Walker::read_limits(const WalkLimits& limits) {
  GLint blocks = 0;
  GLint64 bytes = 0;
  glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  if (std::min(blocks, limits.blocks) < kWalkBlocks) {
    return make_error(StatusCode::unavailable,
                      "no GPU can be used: " + device_->name() + " has too few storage blocks");
  }
  largest_block_ =
      std::min(static_cast<std::size_t>(std::max<GLint64>(bytes, 0)), limits.block_bytes);
  return ok_status();
}

Result<const Program*> Walker::program_of(const WalkTables& tables) {
  std::optional<Program>& program = tables.has_blends() ? blended_ : sharp_;
  if (!program) {
    Result<Program> made = walk_program(*device_, shape_, tables.has_blends());
    if (!made) return make_error(StatusCode::unavailable, made.status().message);
    program = std::move(*made);
  }
  return &*program;
}

const WalkTables& Walker::tables_of(const gather::Scene& scene) {
  const auto found = std::ranges::find(tables_, scene.identity, &WalkTables::scene_identity);
  if (found != tables_.end()) {
    std::rotate(found, found + 1, tables_.end());
  } else {
    if (tables_.size() == kScenes) tables_.erase(tables_.begin());
    tables_.emplace_back(scene);
  }
  return tables_.back();
}

Status Walker::sum(Context& context, const gather::Scene& scene,
                   std::span<const gather::WalkPoint> point, std::span<float> sums) {
  const std::size_t stride = gather::sums_of_point(scene);
  const std::size_t table_bytes = WalkTables::bytes_of(scene), point_bytes = stride * sizeof(float);
  if (table_bytes > largest_block_ || point_bytes * kFirstBatch > largest_block_) {
    for (std::size_t i = 0; i < point.size(); ++i) sums[i * stride] = -1;
    return ok_status();
  }
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, WalkTables::bytes_of(scene), "a scene on the GPU"));
  const WalkTables& tables = tables_of(scene);
  SFUMATO_TRY_ASSIGN(const Program* program, program_of(tables));
  program->use();
  program->set("hit_begin", tables.hit_begin());
  program->set("blend_begin", tables.blend_begin());
  program->set("triangle_begin", tables.triangle_begin());
  program->set("numbers_of_point", static_cast<int>(stride));
  program->set("negligible_share", gather::kPointNegligible);
  program->set("step_limit", kStepLimit);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GLuint(WalkBlock::tables), tables.buffer());
  for (std::size_t i = 0; i < point.size();) {
    if (context.cancelled()) return context.cancel_status();
    const std::size_t most = std::min(batch_, largest_block_ / point_bytes);
    const std::size_t count = std::min(most, point.size() - i);
    const Stopwatch watch;
    SFUMATO_TRY(run(*program, point.subspan(i, count), sums.subspan(i * stride, count * stride)));
    learn_from(watch.seconds(), count);
    i += count;
  }
  return ok_status();
}

/// Times of points may differ very much: a batch grows by doubling, and shrinks at once.
void Walker::learn_from(double seconds, std::size_t points) {
  const double fit = static_cast<double>(points) * kBatchSeconds / std::max(seconds, 1e-6);
  const auto wanted = static_cast<std::size_t>(std::min(fit, double{kLargestBatch}));
  if (points < batch_ && wanted >= batch_) return;
  batch_ = std::clamp(wanted, kFirstBatch / 8, std::min(2 * batch_, kLargestBatch));
}

Status Walker::run(const Program& program, std::span<const gather::WalkPoint> point,
                   std::span<float> sums) {
  const auto bind = [&](WalkBlock block, const GlObject& buffer, std::size_t bytes,
                        const void* data, GLenum usage) {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.name());
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), data, usage);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GLuint(block), buffer.name());
  };
  bind(WalkBlock::points, point_buffer_, point.size_bytes(), point.data(), GL_STREAM_DRAW);
  bind(WalkBlock::results, result_buffer_, sums.size_bytes(), nullptr, GL_STREAM_READ);
  program.set("point_count", static_cast<int>(point.size()));
  const auto group = static_cast<std::size_t>(shape_.local_size);
  glDispatchCompute(static_cast<GLuint>((point.size() + group - 1) / group), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  const void* const results = glMapBufferRange(
      GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(sums.size_bytes()), GL_MAP_READ_BIT);
  if (!results) return lost(*device_);
  std::memcpy(sums.data(), results, sums.size_bytes());
  const bool is_whole = glUnmapBuffer(GL_SHADER_STORAGE_BUFFER) == GL_TRUE;
  return is_whole && glGetError() == GL_NO_ERROR ? ok_status() : lost(*device_);
}

}  // namespace sfumato::gpu
