#pragma once

#include <optional>
#include <string>

#include "apps/config/flight_request.h"
#include "apps/flight/mission.h"
#include "apps/output/result_folder.h"
#include "apps/report/film_strip.h"

namespace lineservo::apps {

/// The texts of a user's own mission, layout and conditions, kept beside the results so that config.yaml
/// repeats the flight wherever the folder is. None for what ships.
struct OwnFiles {
  std::optional<std::string> mission, layout, conditions;
  /// An image beside the layout: its file's name and bytes.
  struct Image {
    std::string name, bytes;
  };
  std::optional<Image> bitmap = {};  ///< of the layout
};

/// The names of all that a flight may leave in its folder.
const std::vector<std::string>& flight_files();

/// Throws InputError when a file cannot be read. Call it before the flight: afterwards they may have changed.
OwnFiles own_files(const FlightRequest& request);

/// Throws InputError when the folder holds a file that a flight would replace, or the next one without it
/// remove, and that is of no earlier flight: it is the user's own. The flight's own files, as they are, may
/// lie there.
void keep_what_is_no_flights(const std::filesystem::path& folder, const OwnFiles& own);

/// Writes summary.json, flight.csv, events.csv, config.yaml, the own files and, where the program has its
/// page, report.html with the pictures of `film`, and publishes them.
void write_flight(ResultFolder& folder, const Mission& mission, const OwnFiles& own,
                  const FlownMission& flown, const FilmStrip& film);

/// Writes report.html alone; false, with a line on stderr, where the program has no page for it.
bool write_flight_report(ResultFolder& folder, const Mission& mission, const FlownMission& flown,
                         const FilmStrip& film);

}  // namespace lineservo::apps
