#pragma once
/// Names, ranges and meanings of the fields of plan files, in the manner of render/scene/field.h.

#include "app/plan/plan.h"
#include "app/plan/scan_mark.h"
#include "render/scene/fields/look_fields.h"

namespace pdr {

inline constexpr Words<VoiFunction, 3> kVoiWords{
    {{"linear", VoiFunction::linear}, {"linearExact", VoiFunction::linearExact}, {"sigmoid", VoiFunction::sigmoid}}};

inline constexpr Words<ViewLayout, 3> kLayoutWords{
    {{"image", ViewLayout::image}, {"beside", ViewLayout::beside}, {"quarters", ViewLayout::quarters}}};

inline constexpr Words<app::MeasureKind, app::kMeasureKinds> kMeasureWords{{{"distance", app::MeasureKind::distance},
                                                                            {"angle", app::MeasureKind::angle},
                                                                            {"lines", app::MeasureKind::lines},
                                                                            {"point", app::MeasureKind::point},
                                                                            {"ball", app::MeasureKind::ball},
                                                                            {"ellipse", app::MeasureKind::ellipse},
                                                                            {"polygon", app::MeasureKind::polygon}}};

inline constexpr Words<measure::Found, 5> kFoundWords{{{"typed", measure::Found::typed},
                                                       {"onSlice", measure::Found::onSlice},
                                                       {"atEdge", measure::Found::atEdge},
                                                       {"picked", measure::Found::picked},
                                                       {"pickedEdge", measure::Found::pickedEdge}}};

template <class Visit>
void describe(Visit& visit, GreyWindow& window) {
    visit({"centreHu", "middle of the window [HU]", {-1e6, 1e6}, kRequired}, window.centre);
    visit({"widthHu", "width of the window [HU]", {1, 1e6}, kRequired}, window.width);
    visit.word({"function", "VOI LUT function of DICOM"}, window.function, kVoiWords);
}

namespace measure {

/// A covariance matrix, which is symmetric.
struct CovarianceField {
    dmat3& mm2;
};

template <class Visit>
void describe(Visit& visit, CovarianceField& field) {
    dvec3 variances(field.mm2[0][0], field.mm2[1][1], field.mm2[2][2]);
    dvec3 covariances(field.mm2[0][1], field.mm2[0][2], field.mm2[1][2]);
    visit({"variancesMm2", "of x, y and z", {0, 1e12}, kRequired}, variances);
    visit({"covariancesMm2", "of x and y, x and z, y and z", {-1e12, 1e12}, kRequired}, covariances);
    if constexpr (Visit::kReads)
        field.mm2 = {variances.x,   covariances.x, covariances.y, covariances.x, variances.y,
                     covariances.z, covariances.y, covariances.z, variances.z};
}

template <class Visit>
void describe(Visit& visit, Place& place) {
    visit({"mm", "where it lies in the patient (LPS)", kPlaceMm, kRequired}, place.mm);
    CovarianceField grid{place.spread.of(Cause::grid)}, edge{place.spread.of(Cause::edge)},
        hand{place.spread.of(Cause::hand)}, light{place.spread.of(Cause::light)};
    visit.object({"grid", "how sure it is: the voxels' share", {}, kRequired}, grid);
    visit.object({"edge", "the noise's share at an edge", {}, kRequired}, edge);
    visit.object({"hand", "the screen's share", {}, kRequired}, hand);
    visit.object({"light", "the share of the depths at which light stops", {}, kRequired}, light);
    visit.word({"found", "how it was found", {}, kRequired}, place.found, kFoundWords);
    visit({"blurMm", "width of the edge; 0: not at an edge", {0, 1e6}}, place.blurMm);
    visit({"thin", "whether another edge is too close to tell apart"}, place.thin);
}

}  // namespace measure

template <class Visit>
void describe(Visit& visit, Hole& hole) {
    visit.direction({"normal", "of its slices, a unit vector (LPS)", {}, kRequired}, hole.normal);
    visit({"fromMm", "where it begins along the normal", kPlaceMm, kRequired}, hole.fromMm);
    visit({"toMm", "where it ends", kPlaceMm, kRequired}, hole.toMm);
}

namespace app {

template <class Visit>
void describe(Visit& visit, ScanMark& scan) {
    visit({"salt", "random, for this file alone", {}, kRequired}, scan.salt);
    visit({"hash", "of the voxels, keyed with the salt", {}, kRequired}, scan.hash);
    visit({"sliceHashes", "of the voxels of each slice, 16 digits each, keyed with the salt"}, scan.sliceHashes);
    visit({"size", "voxels", {1, 16384}, kRequired}, scan.size);
    visit({"spacingMm", "between voxels", {1e-6, 1e6}, kRequired}, scan.spacingMm);
    visit({"importRule", "rule by which voxels were read", {1, 1e6}, kRequired}, scan.importRule);
    visit.list({"holes", "layers in which slices are interpolated; measurements there are marked"}, scan.holes);
}

template <class Visit>
void describe(Visit& visit, SliceFraming& framing) {
    visit({"zoom", "magnification; 1: the whole slice fits", {SliceFraming::kLeastZoom, SliceFraming::kGreatestZoom}},
          framing.zoom);
    dvec3 pan(framing.panMm, 0);
    visit({"panMm", "place in the middle of the view, to the right and down of the slice's; the third number is 0",
           kPlaceMm},
          pan);
    if constexpr (Visit::kReads)
        framing.panMm = dvec2(pan);
}

template <class Visit>
void describe(Visit& visit, Navigation& navigation) {
    visit({"crosshairMm", "the place that all slices contain", kPlaceMm, kRequired}, navigation.crosshairMm);
    visit.object({"axial", "how the axial slice lies in its view"}, navigation.framings[0]);
    visit.object({"coronal", "how the coronal slice lies in its view"}, navigation.framings[1]);
    visit.object({"sagittal", "how the sagittal slice lies in its view"}, navigation.framings[2]);
    visit.object({"window", "what is black and what is white", {}, kRequired}, navigation.window);
    visit.word({"layout", "which of the image and the slices are shown"}, navigation.layout, kLayoutWords);
}

template <class Visit>
void describe(Visit& visit, Measurement& measurement) {
    visit({"id", "random", {}, kRequired}, measurement.id);
    visit.word({"kind", "what is measured", {}, kRequired}, measurement.kind, kMeasureWords);
    visit({"name", "what the user calls it"}, measurement.name);
    visit.list(
        {"places",
         "two for a distance; three for an angle, which is at the second; four for two lines, both ends of each; "
         "one for a point; two for a ball, its middle and a place on its surface; three for an ellipse, its middle and "
         "the ends of two half axes; three to 48 for a polygon, its corners in order",
         {},
         kRequired},
        measurement.places);
}

template <class Visit>
void describe(Visit& visit, PartSources& sources) {
    visit({"labels", "of a label map: hash of its labels and names"}, sources.labels);
    visit({"vessels", "version of the rule that finds vessels; 0: none are wanted", {0, kVesselsRule}},
          sources.vessels);
    visit({"shells", "version of the rule that finds skin and muscle; 0: none are wanted", {0, kShellsRule}},
          sources.shells);
    visit(
        {"mirror", "version of the rule that finds bone that the other side has; 0: none is wanted", {0, kMirrorRule}},
        sources.mirror);
    visit({"metal", "version of the rule that finds implants; 0: none are wanted", {0, kMetalRule}}, sources.metal);
}

template <class Visit>
void describe(Visit& visit, Plan& plan) {
    visit.object({"image", "how the scan is shown", {}, kRequired}, plan.image);
    visit.object({"navigation", "where the slices lie", {}, kRequired}, plan.navigation);
    visit.list({"measurements", "what was measured"}, plan.measurements);
    std::optional<PartSources> parts = plan.partSources.empty() ? std::nullopt : std::optional(plan.partSources);
    visit.object({"parts", "where the parts of the scan come from"}, parts);
    if constexpr (Visit::kReads)
        plan.partSources = parts.value_or(PartSources{});
}

}  // namespace app

}  // namespace pdr
