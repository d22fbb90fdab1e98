#pragma once
/// The provenance and the quality of an image, as stored in its file: text chunks of a PNG, attributes of an OpenEXR
/// file, both under the same names. Nothing about the patient.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "render/film/film_status.h"

namespace pdr {

struct Provenance {
    FilmStatus status;      ///< status on a display of `exposure`
    double exposure = 0;    ///< exposure of the display (see Display)
    std::string toneCurve;  ///< toneCurveName() of the display
    double seconds = 0;     ///< rendering time
    std::uint64_t seed = 0;
    std::string model;
    double extinctionPerMm = 0;
    std::string program;  ///< "PD-Render 0.1.0"
    std::string device;   ///< device that rendered it: "cpu"
    std::string nodes;    ///< what was checked of the samples of render nodes; empty: none had part in it
    std::string effects;  ///< simulated effects: "shadows, highlights"
    std::string look;     ///< name that the user gave the look
    /// The environment image that lights the scene: "2048 x 1024, turned by 30 degrees"; empty: none.
    std::string sky;
    std::string camera;     ///< camera as in scene files
    std::string bias;       ///< causes of bias, each with a name; empty: none known
    std::string estimator;  ///< "kroesMarch (biased)"; empty: the unbiased one
    std::string schedule;   ///< "Exposure Render's K1, blurred"; empty: the program's own
    /// Known problems of the scene: "overDense"; empty: none.
    std::string warnings;
    /// The part of the scan that is hidden, and the rule that hides it: "884 ml of 17.7 l, rule 2, ..."; empty:
    /// nothing.
    std::string hidden;
    std::string cut;  ///< what the user cut away: "box, 1 plane"; empty: nothing
    /// Parts of the body that are not shown, in sentences: "Peeled 7 mm: ..."; empty: all of it is shown.
    std::string notShown;
    std::string remarks;  ///< remarks on the import of the voxels: "lossy clipped"; empty: none
};

struct Fact {
    std::string name;                         ///< "pdrender/seconds"
    std::variant<std::string, double> value;  ///< infinite: not known
};

/// Returns the facts in a fixed order; empty ones are left out.
std::vector<Fact> factsOf(const Provenance& provenance);

/// Returns a fact's value in words; "unknown" for what is infinite.
std::string textOf(const Fact& fact);

}  // namespace pdr
