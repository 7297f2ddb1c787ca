#include "gpu/device.hpp"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <algorithm>
#include <vector>

#include "base/try.hpp"

namespace sfumato::gpu {
namespace {

constexpr int kMostDevices = 16;

Status unavailable(std::string why) {
  return make_error(StatusCode::unavailable, "no GPU can be used: " + std::move(why));
}

/// Returns whether EGL (for EGL_NO_DISPLAY), a display or a device lists an extension.
bool lists(const char* extensions, const char* name) {
  return extensions && epoxy_extension_in_string(extensions, name);
}

/// Epoxy ends the process at a function that it does not find, so that the libraries, and the
/// extension of a function, are checked before the first call.
Status find_libraries() {
  // Never closed, since drivers leave threads running.
  const bool has_gles = dlopen("libGLESv2.so.2", RTLD_NOW | RTLD_LOCAL) != nullptr;
  if (has_gles && epoxy_has_egl()) return ok_status();
  return unavailable("libEGL.so.1 or libGLESv2.so.2 is not installed");
}

/// Returns the displays to try, best first: hardware devices, Mesa without a surface, software
/// devices.
std::vector<EGLDisplay> find_displays() {
  std::vector<EGLDisplay> hardware, software;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!lists(client, "EGL_EXT_platform_base")) return {};
  const auto add = [&](std::vector<EGLDisplay>* list, EGLenum platform, void* device) {
    const EGLDisplay display = eglGetPlatformDisplayEXT(platform, device, nullptr);
    if (display != EGL_NO_DISPLAY) list->push_back(display);
  };
  const bool has_devices =
      lists(client, "EGL_EXT_device_base") ||
      (lists(client, "EGL_EXT_device_enumeration") && lists(client, "EGL_EXT_device_query"));
  EGLDeviceEXT device[kMostDevices];
  EGLint count = 0;
  if (has_devices && lists(client, "EGL_EXT_platform_device") &&
      eglQueryDevicesEXT(kMostDevices, device, &count)) {
    for (EGLint i = 0; i < count; ++i) {
      const bool is_software =
          lists(eglQueryDeviceStringEXT(device[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
      add(is_software ? &software : &hardware, EGL_PLATFORM_DEVICE_EXT, device[i]);
    }
  }
  if (lists(client, "EGL_MESA_platform_surfaceless"))
    add(&hardware, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  hardware.insert(hardware.end(), software.begin(), software.end());
  return hardware;
}

}  // namespace

/// The context, and the context that was current before.
///
/// Displays belong to the process: they are not terminated, since other code may use them too.
struct Device::Egl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLenum previous_api = EGL_NONE;
  EGLDisplay previous_display = EGL_NO_DISPLAY;
  EGLContext previous_context = EGL_NO_CONTEXT;
  EGLSurface previous_draw = EGL_NO_SURFACE, previous_read = EGL_NO_SURFACE;

  bool make_context(EGLDisplay on, DeviceUse use);
  Status make_current(DeviceUse use);
  ~Egl();
};

bool Device::Egl::make_context(EGLDisplay on, DeviceUse use) {
  if (!eglInitialize(on, nullptr, nullptr)) return false;
  if (!lists(eglQueryString(on, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) return false;
  // No surface is made; 0 accepts every kind of surface.
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!eglChooseConfig(on, wanted, &config, 1, &count) || count == 0) return false;
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION,
                            use == DeviceUse::compute ? 1 : 0, EGL_NONE};
  context = eglCreateContext(on, config, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT) return false;
  if (eglMakeCurrent(on, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    display = on;
    return true;
  }
  eglDestroyContext(on, context);
  context = EGL_NO_CONTEXT;
  return false;
}

Status Device::Egl::make_current(DeviceUse use) {
  previous_api = eglQueryAPI();
  if (!eglBindAPI(EGL_OPENGL_ES_API)) return unavailable("EGL here has no OpenGL ES");
  previous_display = eglGetCurrentDisplay();
  previous_context = eglGetCurrentContext();
  previous_draw = eglGetCurrentSurface(EGL_DRAW);
  previous_read = eglGetCurrentSurface(EGL_READ);
  for (EGLDisplay candidate : find_displays())
    if (make_context(candidate, use)) return ok_status();
  return unavailable(std::string("EGL gives no context of OpenGL ES 3") +
                     (use == DeviceUse::compute ? ".1" : "") + " without a window");
}

Device::Egl::~Egl() {
  if (context != EGL_NO_CONTEXT) {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
  }
  if (previous_context != EGL_NO_CONTEXT)
    eglMakeCurrent(previous_display, previous_draw, previous_read, previous_context);
  if (previous_api != EGL_NONE && previous_api != EGL_OPENGL_ES_API) eglBindAPI(previous_api);
}

Device::Device() : egl_(std::make_unique<Egl>()) {}
Device::~Device() = default;

Result<std::unique_ptr<Device>> Device::create(DeviceUse use) {
  std::unique_ptr<Device> device(new Device);
  SFUMATO_TRY(find_libraries());
  SFUMATO_TRY(device->egl_->make_current(use));
  device->read_name();
  if (use == DeviceUse::draw) SFUMATO_TRY(device->read_limits());
  return device;
}

const char* Device::text(GLenum what) const {
  const GLubyte* bytes = glGetString(what);
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
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  largest_side_ = std::min({texture, buffer, viewport[0], viewport[1]});
  return ok_status();
}

}  // namespace sfumato::gpu
