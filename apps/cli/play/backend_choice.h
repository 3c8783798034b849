#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "far/base/result.h"

namespace honeycomb::Cli::Play {

/// Which backend refines the next frame. A name stands for itself; `auto` tries the fast ones in turn on the first
/// frames and stays with the fastest.
class BackendChoice {
 public:
  /// Errors: invalidOption for an unknown name.
  static Result<BackendChoice> parse(const std::string& name);

  /// What refines the next frame.
  const std::string& current() const;
  /// What its frame took, milliseconds: evaluation and upload.
  void took(double milliseconds);
  /// It can't be used here: the others remain. False where there is none.
  bool drop();
  /// What refines the first frame after restart().
  std::string first() const;
  /// The tables are others: tries again where it has to choose.
  void restart();

  const std::string& asked() const { return asked_; }
  bool settled() const { return settled_; }

 private:
  std::string asked_;
  std::vector<std::string> candidates_;
  std::map<std::string, std::vector<double>> times_;
  std::size_t next_ = 0;
  bool settled_ = false;
};

}  // namespace honeycomb::Cli::Play
