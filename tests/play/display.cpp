#include "tests/play/display.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace honeycomb::Test {
namespace {

bool installed(const char* program) {
  return std::system(("command -v " + std::string(program) + " > /dev/null 2>&1").c_str()) == 0;
}

/// The server writes the number of the display that it has taken, once it is ready.
std::string readLine(int pipe) {
  std::string line;
  for (char c = 0; ::read(pipe, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

constexpr std::size_t kScreenWidth = 640;
constexpr std::size_t kScreenHeight = 480;
constexpr std::size_t kPixelBytes = 4;  // blue, green, red and nothing
constexpr std::size_t kRowBytes = kScreenWidth * kPixelBytes;

}  // namespace

std::unique_ptr<Display> Display::open(const std::filesystem::path& folder) {
  if (!installed("Xvfb") || !installed("xdotool")) return nullptr;
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return nullptr;
  const std::string number = std::to_string(ends[1]);
  const pid_t server = fork();
  if (server == 0) {
    ::close(ends[0]);
    const int nothing = ::open("/dev/null", O_WRONLY);
    dup2(nothing, STDERR_FILENO);
    const std::string screen = std::to_string(kScreenWidth) + "x" + std::to_string(kScreenHeight) + "x24";
    execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp",
           "-nocursor", "-fbdir", folder.c_str(), nullptr);
    _exit(127);
  }
  ::close(ends[1]);
  const std::string display = readLine(ends[0]);
  ::close(ends[0]);
  setenv("DISPLAY", (":" + display).c_str(), 1);
  return std::unique_ptr<Display>(new Display(server, folder / "Xvfb_screen0"));
}

Display::~Display() {
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

Viewer::Picture Display::pixels(std::int32_t width, std::int32_t height) const {
  std::ifstream file(screen_, std::ios::binary);
  std::vector<char> bytes(std::filesystem::file_size(screen_));
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  // The pixels are the end of the file. Its header can't be asked: the server turns it to the machine's byte order and
  // back, in place, whenever a window brings another colormap.
  if (bytes.size() < kScreenHeight * kRowBytes) return {};
  const std::size_t start = bytes.size() - kScreenHeight * kRowBytes;
  Viewer::Picture picture{width, height, {}};
  for (std::int32_t y = 0; y < height; ++y)
    for (std::int32_t x = 0; x < width; ++x) {
      const std::size_t at =
          start + kRowBytes * static_cast<std::size_t>(y) + kPixelBytes * static_cast<std::size_t>(x);
      for (const std::size_t channel : {2U, 1U, 0U})
        picture.rgba.push_back(static_cast<std::uint8_t>(bytes.at(at + channel)));
      picture.rgba.push_back(255);
    }
  return picture;
}

void Display::act(const std::string& command) const {
  if (std::system(("xdotool " + command + " > /dev/null 2>&1").c_str()) != 0) std::abort();
}

}  // namespace honeycomb::Test
