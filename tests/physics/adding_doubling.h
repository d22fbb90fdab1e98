#pragma once
/// Plane-parallel slabs by adding and doubling: a second way to the reference values, without a single random number.
/// Azimuthal mean of the intensity, index-matched borders; van de Hulst, Multiple Light Scattering (1980), ch. 4.
/// R(i, j) = pi I(mu_i) / (mu_j F) for a beam from mu_j; integrals over a hemisphere are sums of 2 mu w.

#include <algorithm>
#include <cmath>
#include <vector>

namespace pdr::test {

class AddingDoubling {
  public:
    /// `depth`: optical depth. `extra`: cosines at which values are wanted besides the nodes; `nodes` of Gauss.
    AddingDoubling(double albedo, double g, double depth, std::vector<double> extra, int nodes = 24) : mu_(extra) {
        weight_.assign(extra.size(), 0);
        gauss(nodes);
        size_ = int(mu_.size());
        int doublings = 0;
        double layer = depth;
        for (; layer > 1e-10; layer /= 2)
            ++doublings;
        start(albedo, g, layer);
        for (; doublings > 0; --doublings, layer *= 2)
            doubleUp(layer);
        layer_ = layer;
    }

    /// Reflectance factor out at extra cosine i for a beam in at extra cosine j; the same through (without the beam).
    double reflected(int i, int j) const { return r_[i * size_ + j]; }
    double transmitted(int i, int j) const { return t_[i * size_ + j]; }

    /// Share of a beam at extra cosine j that is reflected; that is let through, with and without a collision.
    double reflectance(int j) const { return flux(r_, j); }
    double transmittance(int j) const { return flux(t_, j) + std::exp(-layer_ / mu_[j]); }

    /// Radiance at extra cosine j, upwards, of what comes in with radiance above(mu) from the upper and below(mu) from
    /// the lower half of the surroundings, by reciprocity; collisions only.
    template <class Above, class Below>
    double scattered(int j, Above&& above, Below&& below) const {
        double total = 0;
        for (int i = 0; i < size_; ++i)
            total += 2 * mu_[i] * weight_[i] * (above(mu_[i]) * r_[i * size_ + j] + below(mu_[i]) * t_[i * size_ + j]);
        return total;
    }

  private:
    using Matrix = std::vector<double>;

    /// Gauss-Legendre on [0, 1] by Newton's method.
    void gauss(int n) {
        for (int i = 0; i < n; ++i) {
            double x = std::cos(M_PI * (i + 0.75) / (n + 0.5)), slope = 1;
            for (int step = 0; step < 50; ++step) {
                double p = 1, before = 0;
                for (int k = 1; k <= n; ++k) {
                    const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                    before = p;
                    p = next;
                }
                slope = n * (x * p - before) / (x * x - 1);
                x -= p / slope;
            }
            mu_.push_back((x + 1) / 2);
            weight_.push_back(1 / ((1 - x * x) * slope * slope));
        }
    }

    /// Azimuthal mean of 4 pi times the Henyey-Greenstein phase function.
    static double phase(double g, double a, double b) {
        double sum = 0, pa = 1, pb = 1, beforeA = 0, beforeB = 0, power = 1;
        for (int l = 0; l < 400 && std::fabs(power) > 1e-14; ++l, power *= g) {
            sum += (2 * l + 1) * power * pa * pb;
            const double nextA = ((2 * l + 1) * a * pa - l * beforeA) / (l + 1);
            const double nextB = ((2 * l + 1) * b * pb - l * beforeB) / (l + 1);
            beforeA = pa, pa = nextA, beforeB = pb, pb = nextB;
        }
        return sum;
    }

    /// A layer so thin that light is scattered in it at most once.
    void start(double albedo, double g, double depth) {
        r_.assign(size_ * size_, 0), t_ = r_;
        for (int i = 0; i < size_; ++i)
            for (int j = 0; j < size_; ++j) {
                const double a = mu_[i], b = mu_[j], strength = albedo / (4 * (a + b));
                r_[i * size_ + j] = strength * phase(g, -a, b) * -std::expm1(-depth * (1 / a + 1 / b));
                const double through = i == j || std::fabs(a - b) < 1e-9
                                           ? depth / (a * a) * std::exp(-depth / a)
                                           : std::exp(-depth / b) * std::expm1(depth * (1 / b - 1 / a)) / (b - a);
                t_[i * size_ + j] = albedo / 4 * phase(g, a, b) * std::fabs(through);
            }
    }

    Matrix product(const Matrix& a, const Matrix& b) const {
        Matrix result(size_ * size_, 0);
        for (int i = 0; i < size_; ++i)
            for (int k = 0; k < size_; ++k) {
                const double left = a[i * size_ + k] * 2 * mu_[k] * weight_[k];
                for (int j = 0; left != 0 && j < size_; ++j)
                    result[i * size_ + j] += left * b[k * size_ + j];
            }
        return result;
    }

    static Matrix sum(Matrix a, const Matrix& b) {
        for (std::size_t i = 0; i < a.size(); ++i)
            a[i] += b[i];
        return a;
    }

    /// Unscattered on the way out (rows) or in (columns).
    Matrix dimmedRows(Matrix a, double depth) const {
        for (int i = 0; i < size_ * size_; ++i)
            a[i] *= std::exp(-depth / mu_[i / size_]);
        return a;
    }
    Matrix dimmedColumns(Matrix a, double depth) const {
        for (int i = 0; i < size_ * size_; ++i)
            a[i] *= std::exp(-depth / mu_[i % size_]);
        return a;
    }

    /// Two equal layers of `depth` on top of each other.
    void doubleUp(double depth) {
        const Matrix bounce = product(r_, r_);
        Matrix all = bounce, next = bounce;  // bounces between the layers, to all orders
        for (int order = 0; order < 200; ++order) {
            next = product(next, bounce);
            all = sum(std::move(all), next);
            if (*std::max_element(next.begin(), next.end()) < 1e-16)
                break;
        }
        const Matrix down = sum(sum(t_, dimmedColumns(all, depth)), product(all, t_));
        const Matrix up = sum(dimmedColumns(r_, depth), product(r_, down));
        r_ = sum(sum(r_, dimmedRows(up, depth)), product(t_, up));
        t_ = sum(sum(dimmedRows(down, depth), dimmedColumns(t_, depth)), product(t_, down));
    }

    double flux(const Matrix& matrix, int j) const {
        double total = 0;
        for (int i = 0; i < size_; ++i)
            total += 2 * mu_[i] * weight_[i] * matrix[i * size_ + j];
        return total;
    }

    std::vector<double> mu_, weight_;
    Matrix r_, t_;
    int size_ = 0;
    double layer_ = 0;
};

}  // namespace pdr::test
