#pragma once

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <string>

#include "apps/viewer/picture.h"

namespace honeycomb::Test {

/// An X server without a screen of glass (Xvfb), whose pixels can be looked at, and keys and a mouse that are pressed
/// by xdotool. While it lives, DISPLAY names it.
class Display {
 public:
  /// Null where Xvfb or xdotool isn't installed.
  static std::unique_ptr<Display> open(const std::filesystem::path& folder);
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  ~Display();

  /// What is on the screen from its upper left corner.
  Viewer::Picture pixels(std::int32_t width, std::int32_t height) const;
  /// One xdotool command, such as "key space".
  void act(const std::string& command) const;

 private:
  Display(pid_t server, std::filesystem::path screen) : server_(server), screen_(std::move(screen)) {}
  pid_t server_ = -1;
  std::filesystem::path screen_;  ///< the frame buffer, an XWD file that the server keeps up to date
};

}  // namespace honeycomb::Test
