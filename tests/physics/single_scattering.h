#pragma once
/// The radiance that singleScattering stands for, by quadrature in double precision: the integral over the view ray of
/// transmittance, extinction and the light that is scattered there, over all lights and the surroundings.

#include "render/scene/scene.h"
#include "tests/physics/written_cut.h"
#include "tests/physics/written_parts.h"

namespace pdr::test::written {

/// The resolution at which lights and the sphere of directions are sampled: points along each side, around the circle
/// twice as many.
struct Fineness {
    int light = 10;
    int sphere = 14;
};

class SingleScattering {
  public:
    explicit SingleScattering(const Scene& scene, Fineness fineness = {})
        : scene_(scene),
          grid_(*scene.volume),
          materials_(scene),
          planes_(scene.clip.allPlanes()),
          onLight_(gaussLegendre(fineness.light)),
          onSphere_(gaussLegendre(fineness.sphere)) {}

    /// Linear Rec. 709, seen from `eye` along the unit vector `direction`. The lights are not in view.
    dvec3 radiance(dvec3 eye, dvec3 direction) const {
        const Line line = uncut(planes_, inBox(grid_, {eye, direction, 0, 1e30}));
        dvec3 sum(0);
        double depth = 0;
        if (line.from < line.to) {
            std::vector<double> ends = kinks(grid_, materials_.nodes(), line);
            const std::vector<double> steps = stepsOf(line, [&](dvec3 place) { return face(place); });
            ends.insert(ends.end(), steps.begin(), steps.end());
            std::sort(ends.begin(), ends.end());
            for (std::size_t i = 0; i + 1 < ends.size() && depth < kOpaque; ++i)
                sum += fromPiece(line, ends[i], ends[i + 1], depth);
        }
        if (scene_.environment.visible)
            sum += std::exp(-depth) * dvec3(scene_.environment.radiance);
        return sum;
    }

  private:
    static constexpr double kOpaque = 30;       ///< optical depth behind which nothing counts
    static constexpr double kPieceDepth = 0.5;  ///< optical depth of the pieces that a path is cut into

    double extinction(dvec3 place) const {
        const dvec3 index = grid_.index(place);
        const double hu = grid_.hu(index);
        double sum = 0;
        for (const WeightedMaterial& material : materials_.at(index))
            sum += material.extinction(hu);
        return sum;
    }

    /// Returns the optical depth between two neighbouring kinks or part of that way.
    template <class Extinction>
    double passed(double from, double to, Extinction&& sigma) const {
        return scene_.parts.map ? depthOf<4>(from, to, sigma) : depthOf<2>(from, to, sigma);
    }

    /// Adds the piece's optical depth to `depth`.
    dvec3 fromPiece(const Line& line, double from, double to, double& depth) const {
        static const std::vector<QuadraturePoint> points = gaussLegendre(6);
        const auto sigma = [&](double t) { return extinction(line.at(t)); };
        const double whole = passed(from, to, sigma);
        const int parts = int(whole / kPieceDepth) + 1;
        dvec3 sum(0);
        for (int part = 0; part < parts && whole > 0; ++part) {
            const double low = from + (to - from) * part / parts, high = from + (to - from) * (part + 1) / parts;
            for (const QuadraturePoint& point : points) {
                const double t = low + (high - low) * point.at;
                const double reached = std::exp(-(depth + passed(low, t, sigma)));
                sum += scattered(line.at(t), line.direction) * (reached * sigma(t) * point.weight * (high - low));
            }
            depth += passed(low, high, sigma);
        }
        return sum;
    }

    /// Share of light that crosses the tissue from `place` along `direction` up to `distance`.
    double transmittance(dvec3 place, dvec3 direction, double distance) const {
        Line line = inBox(grid_, {place, direction, 0, distance});
        if (!scene_.clip.shadows)
            line = uncut(planes_, line);
        if (!(line.from < line.to))
            return 1;
        const std::vector<double> ends = kinks(grid_, materials_.nodes(), line);
        double depth = 0;
        for (std::size_t i = 0; i + 1 < ends.size() && depth < kOpaque; ++i)
            depth += passed(ends[i], ends[i + 1], [&](double t) { return extinction(line.at(t)); });
        return std::exp(-depth);
    }

    /// An event: what it is made of, how it turns light towards the viewer, and where rays to the light start.
    struct Event {
        dvec3 place, travel;
        Tissue tissue;
        dvec3 normal;                ///< points to the viewer's side
        double ofSurface, ofMedium;  ///< probability of a surface, and of none
        double g;
        dvec3 start;
        bool outside = false;  ///< the start is outside a plane edge, which takes some of the light

        dvec3 response(dvec3 toLight) const {
            dvec3 sum = ofMedium * tissue.albedo * henyeyGreenstein(g, glm::dot(travel, toLight));
            if (ofSurface > 0)
                sum += ofSurface * surface(tissue, normal, -travel, toLight) * (outside ? throughEdge(toLight) : 1);
            return sum;
        }
        double throughEdge(dvec3 toLight) const {
            const double light = std::max(glm::dot(normal, toLight), 0.0);
            return light / (light - glm::dot(normal, travel));
        }
    };

    int face(dvec3 place) const { return faceNear(grid_, planes_, scene_.transferFunction.nodes, place); }

    /// Returns the gradient of the HU, or of the step from tissue to air at a cut, which is one voxel wide [HU/mm];
    /// both in the same way.
    dvec3 gradient(dvec3 place) const {
        const dvec3 index = grid_.index(place);
        const int cut = face(place);
        if (cut < 0)
            return grid_.gradient(index);
        const dvec3 normal = glm::normalize(planes_[cut].normal);
        return normal * (std::max(grid_.hu(index) + 1000, 0.0) / glm::length(grid_.acrossIndex(normal)));
    }

    Event eventAt(dvec3 place, dvec3 travel, const WeightedMaterial& material, dvec3 gradient) const {
        const Tissue tissue = tissueAt(material.curve->nodes, grid_.hu(grid_.index(place)));
        Event event{place, travel, tissue, dvec3(0, 0, 1), 0, 1, scene_.phaseG, place};
        const double steepness = glm::length(gradient);
        if (steepness > 0) {
            event.normal = gradient * ((glm::dot(gradient, travel) > 0 ? -1 : 1) / steepness);
            event.ofSurface = surfaceProbability(event.tissue.opacity, material.gradientFactor, steepness);
            event.ofMedium = 1 - event.ofSurface;
        }
        return event;
    }

    /// Radiance scattered towards the viewer at `place`: by each material in proportion to its extinction.
    dvec3 scattered(dvec3 place, dvec3 travel) const {
        const dvec3 index = grid_.index(place), gradient = this->gradient(place);
        const double hu = grid_.hu(index), whole = extinction(place);
        dvec3 sum(0);
        for (const WeightedMaterial& material : materials_.at(index))
            if (const double share = material.extinction(hu) / whole; share > 0)
                sum += share *
                       scatteredBy(eventAt(place, travel, material, materials_.edge(material, index, hu, gradient)));
        return sum;
    }

    dvec3 scatteredBy(const Event& event) const {
        if (scene_.rayOrigin == RayOrigin::event || event.ofSurface == 0)
            return scattered(event);
        Event surface = event, medium = event;
        surface.ofMedium = medium.ofSurface = 0;
        surface.outside = true;
        surface.start = outside(event);
        return scattered(surface) + scattered(medium);
    }

    /// One voxel out along the normal, and not beyond a cut.
    dvec3 outside(const Event& event) const {
        const double voxelMm = 1 / glm::length(grid_.alongIndex(event.normal));
        const Line out = uncut(planes_, {event.place, event.normal, 0, voxelMm});
        return out.at(out.to);
    }

    dvec3 scattered(const Event& event) const {
        dvec3 sum(0);
        for (const Light& light : scene_.lights)
            std::visit([&](const auto& one) { sum += from(one, event); }, light);
        if (!scene_.environment.isBlack())
            sum += fromAllAround(event);
        return sum;
    }

    dvec3 arriving(const Event& event, dvec3 toLight, double distance, dvec3 irradiance) const {
        const dvec3 response = event.response(toLight) * irradiance;
        return response == dvec3(0) ? response : response * transmittance(event.start, toLight, distance);
    }

    dvec3 from(const DirectionalLight& light, const Event& event) const {
        return arriving(event, -glm::normalize(light.direction), 1e30, dvec3(light.irradiance));
    }

    dvec3 from(const RectangleLight& light, const Event& event) const {
        const dvec3 normal = glm::normalize(light.normal), side = glm::normalize(glm::cross(light.up, normal));
        const dvec3 upwards = glm::cross(normal, side);
        dvec3 sum(0);
        for (const QuadraturePoint& u : onLight_)
            for (const QuadraturePoint& v : onLight_) {
                const dvec3 path = light.centreMm + side * ((u.at - 0.5) * light.widthMm) +
                                   upwards * ((v.at - 0.5) * light.heightMm) - event.start;
                const double distance = glm::length(path), cosine = -glm::dot(normal, path) / distance;
                if (cosine > 0)
                    sum += arriving(event, path / distance, distance,
                                    dvec3(light.radiance) * (u.weight * v.weight * light.widthMm * light.heightMm *
                                                             cosine / (distance * distance)));
            }
        return sum;
    }

    dvec3 from(const SphereLight& light, const Event& event) const {
        const dvec3 path = light.centreMm - event.start;
        const double squared = glm::dot(path, path), radius = light.radiusMm;
        const double cone = 1 - std::sqrt(1 - radius * radius / squared);
        return overCircles(path / std::sqrt(squared), onLight_, 1 - cone, 1, [&](dvec3 towards, double solidAngle) {
            const double along = glm::dot(path, towards);
            const double distance = along - std::sqrt(std::max(0.0, along * along - squared + radius * radius));
            return arriving(event, towards, distance, dvec3(light.radiance) * solidAngle);
        });
    }

    dvec3 fromAllAround(const Event& event) const {
        const auto light = [&](dvec3 towards, double solidAngle) {
            return arriving(event, towards, 1e30, dvec3(scene_.environment.radiance) * solidAngle);
        };
        return overCircles(event.normal, onSphere_, 0, 1, light) + overCircles(event.normal, onSphere_, -1, 0, light);
    }

    /// Sum of f(direction, solid angle) over the zone of directions at cosines in [low, high] to `axis`.
    template <class F>
    static dvec3 overCircles(dvec3 axis, const std::vector<QuadraturePoint>& points, double low, double high, F&& f) {
        const dvec3 other = std::fabs(axis.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
        const dvec3 s = glm::normalize(glm::cross(axis, other)), t = glm::cross(axis, s);
        const int around = 2 * int(points.size());
        dvec3 sum(0);
        for (const QuadraturePoint& point : points) {
            const double cosine = low + (high - low) * point.at, sine = std::sqrt(1 - cosine * cosine);
            for (int i = 0; i < around; ++i) {
                const double angle = 2 * M_PI * (i + 0.5) / around;
                sum += f(axis * cosine + (s * std::cos(angle) + t * std::sin(angle)) * sine,
                         point.weight * (high - low) * 2 * M_PI / around);
            }
        }
        return sum;
    }

    const Scene& scene_;
    Grid grid_;
    Materials materials_;
    std::vector<ClipPlane> planes_;
    std::vector<QuadraturePoint> onLight_, onSphere_;
};

}  // namespace pdr::test::written
