# A formula for this checkout's branch main, for Homebrew on Linux, from a private tap:
#
#   brew tap-new local/sfumato
#   cp packaging/homebrew/sfumato.rb "$(brew --repository local/sfumato)/Formula/"
#   HOMEBREW_SFUMATO=$PWD brew install --HEAD local/sfumato/sfumato
#
# It is untested: Homebrew was not available, and Sfumato was never built on macOS. A public formula names a
# release and its sha256 instead of `head`.
class Sfumato < Formula
  desc "Diffusion curves: vector pictures made of curves with a colour on each side"
  license "MIT"
  head "file://#{ENV.fetch("HOMEBREW_SFUMATO", Dir.pwd)}", using: :git, branch: "main"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "pkgconf" => :build
  depends_on "jpeg-turbo"
  depends_on "libepoxy"
  depends_on "libevent"
  depends_on "libspng"
  depends_on "libtiff"
  depends_on :linux
  depends_on "little-cms2"
  depends_on "pugixml"
  depends_on "tbb"
  depends_on "webp"
  depends_on "zlib"

  def install
    system "cmake", "--preset", "release", "-DSFUMATO_TESTS=OFF", "-DSFUMATO_WERROR=OFF", *std_cmake_args
    system "cmake", "--build", "build", "--target", "sfumato", "sfumato_library", "sfumato_c"
    system "cmake", "--install", "build"
  end

  test do
    system bin/"sfumato", "init", "drawing.svg"
    system bin/"sfumato", "render", "drawing.svg", "-o", "drawing.png"
    assert_path_exists testpath/"drawing.png"
  end
end
