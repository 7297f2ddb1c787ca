#include "gpu/device.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/try.hpp"

namespace sfumato::gpu {
namespace {

#define SFUMATO_EGL_FUNCTIONS(F) \
  F(BindAPI)                     \
  F(ChooseConfig)                \
  F(CreateContext)               \
  F(DestroyContext)              \
  F(GetCurrentContext)           \
  F(GetCurrentDisplay)           \
  F(GetCurrentSurface)           \
  F(GetProcAddress)              \
  F(Initialize)                  \
  F(MakeCurrent)                 \
  F(QueryAPI)                    \
  F(QueryString)

struct EglFunctions {
#define SFUMATO_EGL_MEMBER(name) decltype(&::egl##name) name = nullptr;
  SFUMATO_EGL_FUNCTIONS(SFUMATO_EGL_MEMBER)
#undef SFUMATO_EGL_MEMBER
};

constexpr int kMostDevices = 16;

Status unavailable(std::string why) {
  return make_error(StatusCode::unavailable, "no GPU can be used: " + std::move(why));
}

bool lists(const char* extensions, std::string_view name) {
  if (!extensions) return false;
  const std::string_view all(extensions);
  for (std::size_t at = all.find(name); at != std::string_view::npos; at = all.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || all[at - 1] == ' ') && (end == all.size() || all[end] == ' ')) return true;
  }
  return false;
}

template <class Function>
bool find_in(void* library, const char* name, Function* function) {
  *function = reinterpret_cast<Function>(dlsym(library, name));
  return *function != nullptr;
}

template <class Function>
Function extension(const EglFunctions& egl, const char* name) {
  return reinterpret_cast<Function>(egl.GetProcAddress(name));
}

/// Returns the displays to try, best first: hardware devices, Mesa without a surface, software
/// devices.
std::vector<EGLDisplay> find_displays(const EglFunctions& egl) {
  std::vector<EGLDisplay> hardware, software;
  const char* client = egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto display_of =
      extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl, "eglGetPlatformDisplayEXT");
  if (!display_of) return {};
  const auto add = [&](std::vector<EGLDisplay>* list, EGLenum platform, void* device) {
    const EGLDisplay display = display_of(platform, device, nullptr);
    if (display != EGL_NO_DISPLAY) list->push_back(display);
  };
  const auto devices = extension<PFNEGLQUERYDEVICESEXTPROC>(egl, "eglQueryDevicesEXT");
  const auto device_string =
      extension<PFNEGLQUERYDEVICESTRINGEXTPROC>(egl, "eglQueryDeviceStringEXT");
  EGLDeviceEXT device[kMostDevices];
  EGLint count = 0;
  if (lists(client, "EGL_EXT_platform_device") && devices && device_string &&
      devices(kMostDevices, device, &count)) {
    for (EGLint i = 0; i < count; ++i) {
      const bool is_software =
          lists(device_string(device[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
      add(is_software ? &software : &hardware, EGL_PLATFORM_DEVICE_EXT, device[i]);
    }
  }
  if (lists(client, "EGL_MESA_platform_surfaceless"))
    add(&hardware, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  hardware.insert(hardware.end(), software.begin(), software.end());
  return hardware;
}

}  // namespace

/// The libraries, the context, and the context that was current before.
///
/// Displays belong to the process: they are not terminated, since other code may use them too.
struct Device::Egl {
  EglFunctions call;
  void* gles = nullptr;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLenum previous_api = EGL_NONE;
  EGLDisplay previous_display = EGL_NO_DISPLAY;
  EGLContext previous_context = EGL_NO_CONTEXT;
  EGLSurface previous_draw = EGL_NO_SURFACE, previous_read = EGL_NO_SURFACE;

  Status load();
  Status load_functions(Gl* gl, DeviceUse use) const;
  bool make_context(EGLDisplay on, DeviceUse use);
  Status make_current(DeviceUse use);
  ~Egl();
};

Status Device::Egl::load() {
  void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  gles = dlopen("libGLESv2.so.2", RTLD_NOW | RTLD_LOCAL);
  if (!library || !gles) return unavailable("libEGL.so.1 or libGLESv2.so.2 is not installed");
#define SFUMATO_EGL_FIND(name)                    \
  if (!find_in(library, "egl" #name, &call.name)) \
    return unavailable("libEGL.so.1 has no egl" #name);
  SFUMATO_EGL_FUNCTIONS(SFUMATO_EGL_FIND)
#undef SFUMATO_EGL_FIND
  return ok_status();
}

Status Device::Egl::load_functions(Gl* gl, DeviceUse use) const {
#define SFUMATO_GL_FIND(name) \
  if (!find_in(gles, "gl" #name, &gl->name)) return unavailable("libGLESv2.so.2 has no gl" #name);
  SFUMATO_GL_FUNCTIONS(SFUMATO_GL_FIND)
  if (use == DeviceUse::compute) {
    SFUMATO_GL_COMPUTE_FUNCTIONS(SFUMATO_GL_FIND)
  }
#undef SFUMATO_GL_FIND
  return ok_status();
}

bool Device::Egl::make_context(EGLDisplay on, DeviceUse use) {
  if (!call.Initialize(on, nullptr, nullptr)) return false;
  if (!lists(call.QueryString(on, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) return false;
  // No surface is made; 0 accepts every kind of surface.
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!call.ChooseConfig(on, wanted, &config, 1, &count) || count == 0) return false;
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION,
                            use == DeviceUse::compute ? 1 : 0, EGL_NONE};
  context = call.CreateContext(on, config, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT) return false;
  if (call.MakeCurrent(on, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    display = on;
    return true;
  }
  call.DestroyContext(on, context);
  context = EGL_NO_CONTEXT;
  return false;
}

Status Device::Egl::make_current(DeviceUse use) {
  previous_api = call.QueryAPI();
  if (!call.BindAPI(EGL_OPENGL_ES_API)) return unavailable("EGL here has no OpenGL ES");
  previous_display = call.GetCurrentDisplay();
  previous_context = call.GetCurrentContext();
  previous_draw = call.GetCurrentSurface(EGL_DRAW);
  previous_read = call.GetCurrentSurface(EGL_READ);
  for (EGLDisplay candidate : find_displays(call))
    if (make_context(candidate, use)) return ok_status();
  return unavailable(std::string("EGL gives no context of OpenGL ES 3") +
                     (use == DeviceUse::compute ? ".1" : "") + " without a window");
}

Device::Egl::~Egl() {
  if (context != EGL_NO_CONTEXT) {
    call.MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    call.DestroyContext(display, context);
  }
  if (previous_context != EGL_NO_CONTEXT)
    call.MakeCurrent(previous_display, previous_draw, previous_read, previous_context);
  if (previous_api != EGL_NONE && previous_api != EGL_OPENGL_ES_API) call.BindAPI(previous_api);
}

Device::Device() : egl_(std::make_unique<Egl>()) {}
Device::~Device() = default;

Result<std::unique_ptr<Device>> Device::create(DeviceUse use) {
  std::unique_ptr<Device> device(new Device);
  SFUMATO_TRY(device->egl_->load());
  SFUMATO_TRY(device->egl_->load_functions(&device->gl_, use));
  SFUMATO_TRY(device->egl_->make_current(use));
  device->read_name();
  if (use == DeviceUse::draw) SFUMATO_TRY(device->read_limits());
  return device;
}

const char* Device::text(GLenum what) const {
  const GLubyte* bytes = gl_.GetString(what);
  return bytes ? reinterpret_cast<const char*>(bytes) : "";
}

void Device::read_name() {
  name_ = text(GL_RENDERER);
  has_precise_ = lists(text(GL_EXTENSIONS), "GL_EXT_gpu_shader5");
}

Status Device::read_limits() {
  const char* extensions = text(GL_EXTENSIONS);
  if (!lists(extensions, "GL_EXT_color_buffer_float"))
    return unavailable(name_ + " cannot draw to textures of floats");
  blends_floats_ = lists(extensions, "GL_EXT_float_blend");
  GLint texture = 0, buffer = 0, viewport[2] = {};
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  gl_.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
  gl_.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  largest_side_ = std::min({texture, buffer, viewport[0], viewport[1]});
  return ok_status();
}

}  // namespace sfumato::gpu
