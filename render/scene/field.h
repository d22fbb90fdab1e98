#pragma once
/// The fields of scene files, looks and sessions. Each struct that stands in a file is described once, in
/// fields/, by
///     template <class Visit> void describe(Visit& visit, TransferNode& node) {
///         visit({"hu", "Hounsfield units", {-32768, 32767}, kRequired}, node.hu);
///         ...
/// and what visits it reads JSON (field_reader.h), writes it (field_writer.h), checks ranges (field_check.h) or makes
/// the manual's tables (field_table.h). A visitor has
///     visit(field, value)            a number, a flag, a text, a colour, a place, or numbers of another small kind
///     visit.direction(field, value)  three numbers of which only the way counts
///     visit.word(field, value, words)
///     visit.object(field, value)     another described struct; std::optional: it may be absent
///     visit.list(field, values)      a std::vector of them
///     Visit::kReads                  whether it sets values
///     Visit::kBranches               whether it follows each way that a value may go (the manual) or the value's own

#include <array>
#include <string_view>
#include <utility>

#include "render/scene/range.h"

namespace pdr {

inline constexpr bool kRequired = true;

/// All finite numbers.
inline constexpr Range kAnyNumber{-1.7976931348623157e308, 1.7976931348623157e308};

struct Field {
    std::string_view name;     ///< in files
    std::string_view meaning;  ///< for the manual
    Range range = kAnyNumber;  ///< of a number, or of each of several
    bool required = false;     ///< else a fresh struct's value is the default
};

/// The words that a field may hold, and what they mean.
template <class T, std::size_t N>
using Words = std::array<std::pair<std::string_view, T>, N>;

}  // namespace pdr
