#pragma once

#include "apps/compare/comparison_report.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps::testing {

/// A comparison of ibvs and pid along 1.2 m: flights of a fraction of a second.
class ShortStudy {
 public:
  ShortStudy() {
    Block block;
    block.controllers = {"pid", "ibvs"};
    block.instructions = {"node:q"};
    block.layouts = {temp_
                         .write("short.yaml",
                                "name: short\n"
                                "nodes: [{name: p, x_m: 0, y_m: 0}, {name: q, x_m: 1.2, y_m: 0}]\n"
                                "edges: [{from: p, to: q, width_m: 0.1}]\n"
                                "start: {node: p}\n")
                         .string()};
    options.blocks = {block};
    options.tuning = Tuning::published;
    options.conditions = "ideal";
    options.runs = 2;
  }
  Block& block() { return options.blocks.front(); }
  ComparisonResult fly(int jobs) const {
    return {options, "", *Comparison(options).fly(jobs, [](std::size_t) { return true; })};
  }

  ComparisonOptions options;

 private:
  TempFolder temp_;
};

}  // namespace lineservo::apps::testing
