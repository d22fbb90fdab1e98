#pragma once
/// Descriptions of the fields in scene files, looks and sessions. Each struct that is stored in a file is described
/// once, in fields/, by
///     template <class Visit> void describe(Visit& visit, TransferNode& node) {
///         visit({"hu", "Hounsfield units", {-32768, 32767}, kRequired}, node.hu);
///         ...
/// Visitors read JSON (field_reader.h), write it (field_writer.h), check ranges (field_check.h) or make the manual's
/// tables (field_table.h). A visitor has
///     visit(field, value)            a number, a flag, a text, a colour, a place, or a few numbers of another kind
///     visit.direction(field, value)  three numbers of which only the direction matters
///     visit.word(field, value, words)
///     visit.labels(field, value)     a set of labels (segment/labels.h)
///     visit.object(field, value)     another described struct; std::optional: it may be absent
///     visit.list(field, values)      a std::vector of described structs
///     Visit::kReads                  whether it sets values
///     Visit::kBranches               whether it visits the fields of all variants (the manual) or of one

#include <array>
#include <string_view>
#include <utility>

#include "render/scene/range.h"

namespace pdr {

inline constexpr bool kRequired = true;

/// The range of all finite numbers.
inline constexpr Range kAnyNumber{-1.7976931348623157e308, 1.7976931348623157e308};

struct Field {
    std::string_view name;     ///< name in files
    std::string_view meaning;  ///< description for the manual
    Range range = kAnyNumber;  ///< range of the number, or of each of several numbers
    bool required = false;     ///< false: where the field is absent, the default of a new struct applies
};

/// The words that a field may hold, and the value that each word stands for.
template <class T, std::size_t N>
using Words = std::array<std::pair<std::string_view, T>, N>;

}  // namespace pdr
