#include "apps/compare/search.h"

#include <exception>
#include <nlopt.hpp>

namespace lineservo::apps {
namespace {

struct Call {
  const std::function<double(const std::vector<double>&)>& cost;
  std::exception_ptr failure;
};

/// Exceptions go round NLopt, which is written in C.
double evaluate(const std::vector<double>& x, std::vector<double>&, void* data) {
  Call& call = *static_cast<Call*>(data);
  try {
    return call.cost(x);
  } catch (...) {
    call.failure = std::current_exception();
    throw nlopt::forced_stop();
  }
}

}  // namespace

void search_minimum(const SearchBox& box, int budget,
                    const std::function<double(const std::vector<double>&)>& cost) {
  if (box.start.empty() || budget < 2) {
    cost(box.start);
    return;
  }
  Call call{cost, nullptr};
  nlopt::opt optimizer(nlopt::LN_SBPLX, static_cast<unsigned>(box.start.size()));
  optimizer.set_lower_bounds(box.low);
  optimizer.set_upper_bounds(box.high);
  optimizer.set_initial_step(box.first_step);
  optimizer.set_min_objective(evaluate, &call);
  optimizer.set_maxeval(budget);
  std::vector<double> x = box.start;
  double least = 0.0;
  try {
    optimizer.optimize(x, least);
  } catch (const nlopt::forced_stop&) {
    std::rethrow_exception(call.failure);
  } catch (const nlopt::roundoff_limited&) {
    return;  // as near to the minimum as numbers allow
  }
}

}  // namespace lineservo::apps
