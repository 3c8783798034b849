#include <memory>
#include <mutex>
#include <optional>

#include "io/point_cache.h"
#include "io/stream_writer.h"
#include "python/arrays.h"
#include "python/failure.h"

namespace honeycomb::Python {
namespace {

/// What `make` returns, a Result. Throws Failure.
template <class Make>
auto unlockedValue(const Make& make) {
  std::optional<typename decltype(make())::value_type> value;
  unlockedResult([&]() -> Result<void> {
    auto made = make();
    if (!made) return tl::unexpected(made.error());
    value.emplace(std::move(*made));
    return {};
  });
  return std::move(*value);
}

/// The frames of a point cache, by number.
class Frames {
 public:
  explicit Frames(const std::filesystem::path& path) : source_(unlockedValue([&] { return open(path); })) {}

  const Io::FrameInfo& info() const { return source_->info(); }
  /// As frames are counted, whatever the file counts.
  double inFrames(float time) const { return time * (info().countsSeconds() ? info().playedAt() : 1); }

  /// In the mapped file where its bytes are the machine's numbers, else decoded.
  static py::array frame(const py::object& self, std::int64_t index) {
    const auto& frames = self.cast<const Frames&>();
    const std::int32_t count = frames.info().frameCount;
    const std::int64_t f = index < 0 ? index + count : index;
    if (f < 0 || f >= count) throw py::index_error("there is no such frame; there are " + std::to_string(count));
    auto storage = std::make_unique<std::vector<float>>();
    const std::span<const float> points =
        unlockedValue([&] { return frames.source_->frame(static_cast<std::int32_t>(f), *storage); });
    const std::vector<py::ssize_t> shape{frames.info().pointCount, 3};
    if (points.data() != storage->data()) return viewOf(points.data(), shape, self);
    const py::capsule owner(storage.release(), [](void* own) { delete static_cast<std::vector<float>*>(own); });
    return viewOf(points.data(), shape, owner);
  }

 private:
  static Result<std::shared_ptr<const Io::FrameSource>> open(const std::filesystem::path& path) {
    const Result<const Io::PointCache*> kind = Io::pointCache(path);
    if (!kind) return tl::unexpected(kind.error());
    return (*kind)->open(path);
  }

  std::shared_ptr<const Io::FrameSource> source_;
};

/// A point cache on its way: it has its name only when it is whole.
class FrameWriter {
 public:
  FrameWriter(const std::filesystem::path& path, std::int32_t points, std::int32_t frames, double start, double rate,
              double framesPerSecond)
      : points_(points) {
    Io::FrameInfo info;
    info.pointCount = points;
    info.frameCount = frames;
    info.start = static_cast<float>(start);
    info.rate = static_cast<float>(rate);
    info.framesPerSecond = static_cast<float>(framesPerSecond);
    writer_.emplace(unlockedValue([&]() -> Result<Io::StreamWriter> {
      const Result<const Io::PointCache*> kind = Io::pointCache(path);
      if (!kind) return tl::unexpected(kind.error());
      auto layout = (*kind)->layout(path.string(), info, framesPerSecond);
      if (!layout) return tl::unexpected(layout.error());
      return Io::StreamWriter::create(path, *layout);
    }));
  }

  void write(const py::object& points) {
    const std::span<const float> given = packedPointsOf(points, "points", points_);
    run([&](Io::StreamWriter& writer) { return writer.write(given); });
  }

  void finish() {
    run([&](Io::StreamWriter& writer) { return end(writer); });
  }

  /// The end of a with block: whole, or nothing.
  void leave(const py::object& exception, const py::object&, const py::object&) {
    const bool whole = exception.is_none();
    unlockedResult([&]() -> Result<void> {
      const std::scoped_lock alone(busy_);
      if (writer_ && whole) return end(*writer_);
      writer_.reset();
      return {};
    });
  }

 private:
  /// Python's threads may share one: calls go one after another.
  template <class Call>
  void run(const Call& call) {
    unlockedResult([&]() -> Result<void> {
      const std::scoped_lock alone(busy_);
      if (!writer_) return Capi::refuse("this writer is done; make another FrameWriter");
      return call(*writer_);
    });
  }

  Result<void> end(Io::StreamWriter& writer) {
    Result<void> finished = writer.finish();
    writer_.reset();
    return finished;
  }

  std::int32_t points_;
  std::optional<Io::StreamWriter> writer_;
  std::mutex busy_;
};

constexpr const char* kFramesText =
    R"(The frames of a point cache (.pc2, .mdd), by number: frames[i] is (points, 3) float32.

Those of PC2 are the mapped file's own memory, not to be written. Raises Error, also for a frame with NaN or infinity.)";

constexpr const char* kWriterText = R"(Writes a point cache (.pc2, .mdd), which has its name only when it is whole.

points, frames     how many there will be
start, rate        time of the first frame and between two, in frames
frames_per_second  of these times

    with FrameWriter("fine.pc2", points=9666, frames=72) as writer:
        writer.write(refined)     # 72 times; an exception leaves nothing behind)";

void addReading(py::module_& module) {
  py::class_<Frames>(module, "Frames", kFramesText)
      .def(py::init<const std::filesystem::path&>(), py::arg("path"))
      .def("__len__", [](const Frames& frames) { return frames.info().frameCount; })
      .def("__getitem__", &Frames::frame, py::arg("index"))
      .def("__iter__",
           [](const py::object& self) { return py::reinterpret_steal<py::iterator>(PySeqIter_New(self.ptr())); })
      .def_property_readonly(
          "points", [](const Frames& frames) { return frames.info().pointCount; }, "How many a frame has.")
      .def_property_readonly(
          "start", [](const Frames& frames) { return frames.inFrames(frames.info().start); },
          "Time of the first frame, in frames.")
      .def_property_readonly(
          "rate", [](const Frames& frames) { return frames.inFrames(frames.info().rate); },
          "Time between two frames, in frames.")
      .def_property_readonly(
          "frames_per_second", [](const Frames& frames) { return frames.info().playedAt(); },
          "24 where the file doesn't say.");
}

}  // namespace

void addPointCaches(py::module_& module) {
  addReading(module);
  py::class_<FrameWriter>(module, "FrameWriter", kWriterText)
      .def(py::init<const std::filesystem::path&, std::int32_t, std::int32_t, double, double, double>(),
           py::arg("path"), py::arg("points"), py::arg("frames"), py::kw_only(), py::arg("start") = 0.0,
           py::arg("rate") = 1.0, py::arg("frames_per_second") = Io::kUsualFramesPerSecond)
      .def("write", &FrameWriter::write, py::arg("points"),
           "The next frame: (points, 3) float32, packed. Raises TypeError, ValueError, Error.")
      .def("finish", &FrameWriter::finish, "Puts the file under its name; a with block does it. Raises Error.")
      .def("__enter__", [](const py::object& self) { return self; })
      .def("__exit__", &FrameWriter::leave, py::arg("type"), py::arg("value"), py::arg("traceback"));
}

}  // namespace honeycomb::Python
