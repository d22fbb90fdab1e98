#include "tests/hard_cases/trusting_is_nan.h"

namespace pdr::test {

bool trustingIsNan(float x) {
    return x != x;
}

}  // namespace pdr::test
