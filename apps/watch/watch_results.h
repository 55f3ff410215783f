#pragma once

#include <optional>
#include <string>

#include "apps/output/result_folder.h"
#include "apps/recording/recorder.h"
#include "apps/watch/open_watch.h"
#include "apps/watch/watch.h"

namespace lineservo::apps {

/// The files that watching leaves: the CSV file of --out and the recording of --record, whole or not at all.
class WatchResults {
 public:
  /// Proves that they can be written. Throws InputError.
  WatchResults(const std::optional<std::string>& out, const std::optional<std::string>& record,
               const WatchRequest& request, const OpenWatch& opened);

  /// Keeps a tick; returns its row.
  std::string add(const Watched& watched);
  void publish();

 private:
  void begin_recording(const std::string& folder, const WatchRequest& request, const OpenWatch& opened);

  std::string out_name_;
  std::optional<ResultFolder> out_, record_;
  std::optional<Recorder> recorder_;
  std::string config_, camera_;
  std::string table_;
};

}  // namespace lineservo::apps
