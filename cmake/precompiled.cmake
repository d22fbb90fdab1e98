# pdr_precompile(TARGET [HEADER...]): the standard library, and these, are parsed once for all sources of TARGET. Sources
# include what they use all the same: clang-tidy looks at them without.
function(pdr_precompile target)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <cstdint> <functional> <memory> <optional>
                            <string> <utility> <vector> ${ARGN})
endfunction()
