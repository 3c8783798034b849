#include "tests/play/file_drop.h"

#include <poll.h>
#include <xcb/xcb.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <memory>

namespace honeycomb::Test {
namespace {

using Clock = std::chrono::steady_clock;

struct FreeReply {
  void operator()(void* reply) const { std::free(reply); }
};
template <class Reply>
using Owned = std::unique_ptr<Reply, FreeReply>;

class DragSource {
 public:
  DragSource() : x_(xcb_connect(nullptr, nullptr)) {
    root_ = xcb_setup_roots_iterator(xcb_get_setup(x_)).data->root;
    source_ = xcb_generate_id(x_);
    xcb_create_window(x_, XCB_COPY_FROM_PARENT, source_, root_, 0, 0, 1, 1, 0, XCB_WINDOW_CLASS_INPUT_OUTPUT,
                      XCB_COPY_FROM_PARENT, 0, nullptr);
    xcb_set_selection_owner(x_, source_, atom("XdndSelection"), XCB_CURRENT_TIME);
  }
  ~DragSource() { xcb_disconnect(x_); }
  DragSource(const DragSource&) = delete;
  DragSource& operator=(const DragSource&) = delete;

  bool drop(const std::string& uris) {
    uris_ = uris;
    target_ = windowThatTakesFiles();
    if (target_ == XCB_NONE) return false;
    constexpr std::uint32_t kVersion = 5U << 24U;
    constexpr std::uint32_t kPlace = 20U << 16U | 20U;  // x and y on the screen
    send("XdndEnter", {source_, kVersion, atom("text/uri-list"), 0, 0});
    send("XdndPosition", {source_, 0, kPlace, XCB_CURRENT_TIME, atom("XdndActionCopy")});
    if ((answer("XdndStatus") & 1U) == 0) return false;
    send("XdndDrop", {source_, 0, XCB_CURRENT_TIME, 0, 0});
    return answer("XdndFinished") != 0;  // GLFW tells the number of bytes
  }

 private:
  xcb_atom_t atom(const std::string& name) const {
    const auto asked = xcb_intern_atom(x_, 0, static_cast<std::uint16_t>(name.size()), name.c_str());
    const Owned<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(x_, asked, nullptr));
    return reply ? reply->atom : xcb_atom_t{XCB_NONE};
  }
  xcb_window_t windowThatTakesFiles() const {
    const Owned<xcb_query_tree_reply_t> tree(xcb_query_tree_reply(x_, xcb_query_tree(x_, root_), nullptr));
    if (!tree) return XCB_NONE;
    const xcb_window_t* windows = xcb_query_tree_children(tree.get());
    for (int i = 0; i < xcb_query_tree_children_length(tree.get()); ++i) {
      const auto asked = xcb_get_property(x_, 0, windows[i], atom("XdndAware"), XCB_ATOM_ANY, 0, 1);
      const Owned<xcb_get_property_reply_t> reply(xcb_get_property_reply(x_, asked, nullptr));
      if (reply && xcb_get_property_value_length(reply.get()) > 0) return windows[i];
    }
    return XCB_NONE;
  }
  void send(const std::string& message, const std::array<std::uint32_t, 5>& data) const {
    xcb_client_message_event_t event{};
    event.response_type = XCB_CLIENT_MESSAGE;
    event.format = 32;
    event.window = target_;
    event.type = atom(message);
    for (std::size_t i = 0; i < data.size(); ++i) event.data.data32[i] = data[i];
    xcb_send_event(x_, 0, target_, XCB_EVENT_MASK_NO_EVENT, reinterpret_cast<const char*>(&event));
    xcb_flush(x_);
  }
  /// What the target says to it, 0 being a no; hands the files' names out meanwhile.
  std::uint32_t answer(const std::string& message) const {
    const xcb_atom_t wanted = atom(message);
    const auto end = Clock::now() + std::chrono::seconds(10);
    while (Clock::now() < end) {
      const Owned<xcb_generic_event_t> event(xcb_poll_for_event(x_));
      if (!event) {
        pollfd descriptor{xcb_get_file_descriptor(x_), POLLIN, 0};
        poll(&descriptor, 1, 50);
        continue;
      }
      const int kind = event->response_type & 0x7F;
      if (kind == XCB_SELECTION_REQUEST) handOut(*reinterpret_cast<xcb_selection_request_event_t*>(event.get()));
      if (kind != XCB_CLIENT_MESSAGE) continue;
      const auto& told = *reinterpret_cast<xcb_client_message_event_t*>(event.get());
      if (told.type == wanted) return told.data.data32[1];
    }
    return 0;
  }
  void handOut(const xcb_selection_request_event_t& request) const {
    xcb_change_property(x_, XCB_PROP_MODE_REPLACE, request.requestor, request.property, request.target, 8,
                        static_cast<std::uint32_t>(uris_.size()), uris_.data());
    xcb_selection_notify_event_t event{};
    event.response_type = XCB_SELECTION_NOTIFY;
    event.time = request.time;
    event.requestor = request.requestor;
    event.selection = request.selection;
    event.target = request.target;
    event.property = request.property;
    xcb_send_event(x_, 0, request.requestor, XCB_EVENT_MASK_NO_EVENT, reinterpret_cast<const char*>(&event));
    xcb_flush(x_);
  }

  xcb_connection_t* x_;
  xcb_window_t root_ = XCB_NONE, source_ = XCB_NONE, target_ = XCB_NONE;
  std::string uris_;
};

}  // namespace

bool dropFiles(const std::vector<std::string>& paths) {
  std::string uris;
  for (const std::string& path : paths) uris += "file://" + path + "\r\n";
  return DragSource().drop(uris);
}

}  // namespace honeycomb::Test
