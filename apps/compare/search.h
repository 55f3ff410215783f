#pragma once

#include <functional>
#include <vector>

namespace lineservo::apps {

/// A box to search and where to begin.
struct SearchBox {
  std::vector<double> start, low, high;
  double first_step = 0.4;
};

/// Calls `cost` for `budget` points of the box at most, the start first, so as to find where it is least:
/// Sbplx (Rowan's Subplex as NLopt has it), which takes no derivative and no chance: the same costs are the
/// same points. An exception of `cost` ends the search and is thrown on.
void search_minimum(const SearchBox& box, int budget,
                    const std::function<double(const std::vector<double>&)>& cost);

}  // namespace lineservo::apps
