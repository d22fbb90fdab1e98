#pragma once
/// Where light meets tissue on a line of sight, by brute force in double precision. It shares nothing with free flights
/// but the scene: the line comes from ViewGeometry, and cuts and masks are asked at each step.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "render/scene/edit/view_geometry.h"
#include "tests/support/scenes/ray_reference.h"

namespace pdr::test {

/// The line of sight under one point of the image, marched by the midpoint rule in steps of `kStepMm`, which are 50
/// times finer where the extinction may jump: where the HU pass a node, and at cuts.
class MarchedLight {
  public:
    static constexpr double kStepMm = 0.02;

    /// `point`: fractions of the image's width and height.
    MarchedLight(const Scene& scene, dvec2 point)
        : line_(ViewGeometry(scene.camera, double(scene.film.x) / scene.film.y).under(point)) {
        const VolumeGeometry& geometry = scene.volume->geometry();
        const double middle = glm::dot(geometry.centreMm() - line_.originMm, line_.direction);
        start_ = std::max(0.0, middle - geometry.radiusMm());
        const auto steps = std::size_t((middle + geometry.radiusMm() - start_) / kStepMm);
        const dmat4 indexFromPatient = glm::inverse(geometry.patientFromIndex);
        depths_.push_back(0);
        tissue_.push_back(0);
        for (std::size_t i = 0; i < steps; ++i) {
            const double from = start_ + double(i) * kStepMm;
            const int parts = mayJump(scene, indexFromPatient, from) ? 50 : 1;
            double depth = 0, tissue = 0;
            for (int part = 0; part < parts; ++part) {
                const double extinction =
                    extinctionAt(scene, indexFromPatient, at(from + (part + 0.5) / parts * kStepMm));
                depth += extinction * kStepMm / parts;
                tissue += extinction > 0 ? kStepMm / parts : 0;
            }
            depths_.push_back(depths_.back() + depth);
            tissue_.push_back(tissue_.back() + tissue);
        }
    }

    dvec3 at(double mm) const { return line_.originMm + line_.direction * mm; }
    /// Returns how far along the line a place on it lies [mm].
    double along(dvec3 placeMm) const { return glm::dot(placeMm - line_.originMm, line_.direction); }
    /// Returns the share of the light that has met tissue up to `mm` along the line.
    double metBefore(double mm) const { return -std::expm1(-interpolated(depths_, mm)); }
    double met() const { return -std::expm1(-depths_.back()); }
    /// Returns the length of the line before `mm` on which the extinction is above 0 [mm].
    double tissueBefore(double mm) const { return interpolated(tissue_, mm); }
    /// Returns bounds on the most light that any stretch of `window` mm holds: of whole steps that lie in such a
    /// stretch, and of whole steps in which it lies.
    std::pair<double, double> mostWithin(double window) const {
        const auto steps = std::size_t(window / kStepMm);
        return {mostIn(steps), mostIn(steps + 2)};
    }

  private:
    static bool isThere(const Scene& scene, dvec3 placeMm, dvec3 index) {
        const dvec3 size(scene.volume->size());
        return !glm::any(glm::lessThan(index, dvec3(-0.5))) && !glm::any(glm::greaterThan(index, size - 0.5)) &&
               std::ranges::none_of(scene.clip.planes, [&](const ClipPlane& plane) {
                   return glm::dot(plane.normal, placeMm - plane.pointMm) > 0;
               });
    }

    static double extinctionAt(const Scene& scene, const dmat4& indexFromPatient, dvec3 placeMm) {
        const dvec3 index(indexFromPatient * dvec4(placeMm, 1));
        if (!isThere(scene, placeMm, index))
            return 0;
        return opticsAt(scene.transferFunction, huAt(*scene.volume, index)).extinction *
               (scene.mask ? scene.mask->at(index) : 1);
    }

    /// Returns whether the extinction may jump in the step that begins at `mm`.
    bool mayJump(const Scene& scene, const dmat4& indexFromPatient, double mm) const {
        const dvec3 from = at(mm), to = at(mm + kStepMm);
        const dvec3 begin(indexFromPatient * dvec4(from, 1)), end(indexFromPatient * dvec4(to, 1));
        const double before = huAt(*scene.volume, begin), behind = huAt(*scene.volume, end);
        return isThere(scene, from, begin) != isThere(scene, to, end) ||
               std::ranges::any_of(scene.transferFunction.nodes, [&](const TransferNode& node) {
                   return (node.hu - before) * (node.hu - behind) <= 0;
               });
    }

    double mostIn(std::size_t steps) const {
        double most = 0;
        for (std::size_t i = 0; i < depths_.size(); ++i)
            most = std::max(most, std::exp(-depths_[i]) - std::exp(-depths_[std::min(i + steps, depths_.size() - 1)]));
        return most;
    }

    double interpolated(const std::vector<double>& sums, double mm) const {
        const double place = std::clamp((mm - start_) / kStepMm, 0.0, double(sums.size() - 1));
        const auto before = std::min(std::size_t(place), sums.size() - 2);
        return sums[before] + (place - double(before)) * (sums[before + 1] - sums[before]);
    }

    SightLine line_;
    double start_ = 0;            ///< mm along the line
    std::vector<double> depths_;  ///< optical depth up to each step
    std::vector<double> tissue_;  ///< length of tissue up to each step [mm]
};

}  // namespace pdr::test
