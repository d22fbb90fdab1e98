#pragma once
/// How a picture came about and how good it is, as it stands in the files that it is saved in: texts of a PNG,
/// attributes of an OpenEXR file, both under the same names. Nothing of the patient.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "render/film/film_status.h"

namespace pdr {

struct Provenance {
    FilmStatus status;    ///< on a display of `exposure`
    double exposure = 0;  ///< that a linear picture is to be multiplied by
    double seconds = 0;   ///< spent on rendering it
    std::uint64_t seed = 0;
    std::string model;
    double extinctionPerMm = 0;
    std::string program;  ///< "PD-Render 0.1.0"
    std::string device;   ///< that rendered it: "cpu"
    std::string effects;  ///< that were simulated: "shadows, highlights"
    std::string look;     ///< what the user calls it
    std::string sky;      ///< picture of surroundings that lights it: "2048 x 1024, turned by 30 degrees"; empty: none
    std::string camera;   ///< as scene files hold it
    std::string bias;     ///< what chance does not explain, each cause with a name; empty: nothing is known
    std::string estimator;  ///< "kroesMarch (biased)"; empty: the unbiased one
    std::string schedule;   ///< "Exposure Render's K1, blurred"; empty: ours
    std::string warnings;   ///< what is known to be off about the scene: "overDense"; empty: nothing
    std::string hidden;     ///< of the scan, and by which rule: "884 ml of 17.7 l, rule 2, ..."; empty: nothing
    std::string cut;        ///< away by the user: "box, 1 plane"; empty: nothing
    std::string notShown;   ///< of the body, in sentences: "Peeled 7 mm: ..."; empty: all of it is
    std::string remarks;    ///< on the import of the voxels, in words: "lossy clipped"; empty: none
};

struct Fact {
    std::string name;                         ///< "pdrender/seconds"
    std::variant<std::string, double> value;  ///< infinite: not known
};

/// In a fixed order; what is empty is left out.
std::vector<Fact> factsOf(const Provenance& provenance);

/// A fact's value in words; "unknown" for what is infinite.
std::string textOf(const Fact& fact);

}  // namespace pdr
