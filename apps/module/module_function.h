#pragma once

namespace lineservo::apps {

/// A symbol of one of the program's modules (apps/CMakeLists.txt), which is loaded by the first call. Throws
/// std::runtime_error, "the WHAT do not load: ...", when it is not there.
void* module_symbol(const char* module, const char* symbol, const char* what);

/// The same as a function, which must be of this type.
template <typename Function>
Function module_function(const char* module, const char* symbol, const char* what) {
  return reinterpret_cast<Function>(module_symbol(module, symbol, what));
}

}  // namespace lineservo::apps
