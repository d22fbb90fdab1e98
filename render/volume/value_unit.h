#pragma once
/// The unit of a volume's voxels: Hounsfield units, or the values that the files of another modality state. Voxels are
/// whole numbers of 16 bits; a unit other than HU says which value each stands for. It travels in the volume's remarks,
/// so that whatever keeps those keeps the unit, and images state it.

#include <string>
#include <string_view>

#include "render/base/text.h"

namespace pdr {

class Volume;

struct ValueUnit {
    bool isHu = true;
    std::string name;  ///< unit of values that are no HU: "Bq/ml", at most kLongestName characters; empty: not known
    double step = 1;   ///< value = step * voxel + zero; finite, > 0. 1 for HU
    double zero = 0;   ///< finite. 0 for HU

    static constexpr std::size_t kLongestName = 24;

    /// Returns the unit of values that are no HU. Characters of `name` other than visible ASCII, and "," and "=",
    /// become "_".
    static ValueUnit other(std::string name, double step = 1, double zero = 0);

    double valueOf(double voxel) const { return step * voxel + zero; }
    double voxelOf(double value) const { return (value - zero) / step; }
    /// Returns the value of a voxel to as many digits as decimals() says; no -0.
    double roundedValueOf(double voxel) const;
    /// Returns whether a voxel is the value itself.
    bool isPlain() const { return step == 1 && zero == 0; }
    /// Returns the number of digits behind the decimal point that tell neighbouring voxels apart; 0 for HU.
    int decimals() const;

    bool operator==(const ValueUnit&) const = default;
};

/// Values from the lowest to the highest; those that are no numbers are left out.
struct ValueRange {
    double lowest = 0, highest = 0;
    bool areWhole = true;  ///< whether all are whole numbers

    /// The range of no value, which values and other ranges widen.
    static ValueRange none();
    void include(double value);
    void include(const ValueRange& other);
    /// Returns whether there is a value, and all are finite.
    bool isFinite() const;
};

/// Numbers at even distances, which values are known to be among: zero + step * n.
struct ValueSteps {
    double step = 0;  ///< > 0; 0: none are known
    double zero = 0;
};

/// A unit, and whether its voxels stand for all values exactly.
struct FittedUnit {
    ValueUnit unit;
    bool isExact = true;
};

/// Returns the unit of the voxels of values in `range`, which is finite, that are no HU. A voxel is the value itself if
/// all are whole numbers, or else counts the `steps`, shifted into 16 bits where that needs it: no value is rounded
/// then. Where both span more than 16 bits, or no steps are known, the 65,536 steps of a voxel span the range.
FittedUnit fittedUnit(const std::string& name, const ValueRange& range, const ValueSteps& steps);

/// Returns the word that stands for `unit` in a volume's remarks: "no-hu", "no-hu:Bq/ml", "no-hu:Bq/ml=0.25@0"; empty
/// for HU.
std::string unitWord(const ValueUnit& unit);
/// Returns the unit that `remarks` state: HU, unless they hold such a word. A damaged one is a unit without a name.
ValueUnit unitIn(std::string_view remarks);
/// Returns the unit of the volume's voxels.
ValueUnit unitOf(const Volume& volume);

/// Returns what stands behind a number of that unit: "HU", "Bq/ml", or "(no unit)".
Text unitText(const ValueUnit& unit);

}  // namespace pdr
