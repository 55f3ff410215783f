#pragma once

#include <string>

#include "apps/config/flight_request.h"
#include "apps/flight/flight.h"
#include "apps/output/flight_summary.h"
#include "servo/plan/plan.h"

namespace lineservo::apps {

/// One line on stderr that says how far the flight is: rewritten in place on a terminal, else a line now and
/// then.
class ProgressLine {
 public:
  explicit ProgressLine(std::string instruction);
  void show(const FlightProgress& progress);
  void clear();

 private:
  std::string instruction_;
  bool on_terminal_;
  double next_s_ = 0.0;
};

void print_plan(const servo::Plan& plan);
void print_summary(const FlightRequest& request, const FlightRecord& record, const FlightSummary& summary);

}  // namespace lineservo::apps
