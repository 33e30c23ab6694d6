// The reference real: IEEE binary128 significance (113 bits), portable.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace thetalane {

using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;

} // namespace thetalane
