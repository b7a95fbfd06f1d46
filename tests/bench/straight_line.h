// One predict and update of the paper's filter (5)-(11), written out by hand for n = 1, 2 and 3:
// what the product's filter is measured against. No checks, no generality, everything in registers.
// The observed error is y = w (T - phi'x)^2 (8); Q = alpha |x| (10); R = beta (11).
#pragma once

#include <cmath>

namespace searig::bench {

struct Sample {
  double phi[3];  ///< regressors
  double T;       ///< drive torque, N*m
  double w;       ///< trust weight
};

constexpr double alpha = 1e-4, beta = 1;

struct StraightLine1 {
  double x = 50, P = 100;

  void step(const Sample& s) {
    constexpr double W0 = 2.0 / 3, W1 = 1.0 / 6;  // exact for squares
    P += alpha * std::abs(x);
    const double d = 1.7320508075688772 * std::sqrt(P);
    const double r0 = s.T - s.phi[0] * x, step = s.phi[0] * d;
    const double r1 = r0 + step, r2 = r0 - step;
    const double y0 = s.w * r0 * r0, y1 = s.w * r1 * r1, y2 = s.w * r2 * r2;
    const double y = W0 * y0 + W1 * (y1 + y2);
    const double e0 = y0 - y, e1 = y1 - y, e2 = y2 - y;
    const double Pyy = W0 * e0 * e0 + W1 * (e1 * e1 + e2 * e2) + beta;
    const double Pxy = W1 * d * (e2 - e1);
    const double K = Pxy / Pyy;
    x -= K * y;
    P -= K * Pxy;
  }
};

/// The scaled simplex of n = 2 and 3: w0 = 0, spread 1e-5, beta 2.
constexpr double spread = 1e-5, spread2 = spread * spread;

struct StraightLine2 {
  double x0 = 50, x1 = 10, P00 = 100, P10 = 0, P11 = 100;

  void step(const Sample& s) {
    constexpr double W = 1 / spread2 / 3, Wm0 = 1 - 1 / spread2, Wc0 = Wm0 + 3 - spread2;
    const double z0 = spread * 1.2247448713915890, z1 = spread * 0.7071067811865475;
    P00 += alpha * std::abs(x0);
    P11 += alpha * std::abs(x1);
    const double L00 = std::sqrt(P00), L10 = P10 / L00, L11 = std::sqrt(P11 - L10 * L10);
    const double a0 = z0 * L00, a1 = z0 * L10, b = z1 * L11;
    const double r = s.T - s.phi[0] * x0 - s.phi[1] * x1;
    const double first = s.phi[0] * a0 + s.phi[1] * a1, second = s.phi[1] * b;
    const double r1 = r + first + second, r2 = r - first + second, r3 = r - 2 * second;
    const double y0 = s.w * r * r, y1 = s.w * r1 * r1, y2 = s.w * r2 * r2, y3 = s.w * r3 * r3;
    const double y = Wm0 * y0 + W * (y1 + y2 + y3);
    const double e0 = y0 - y, e1 = y1 - y, e2 = y2 - y, e3 = y3 - y;
    const double Pyy = Wc0 * e0 * e0 + W * (e1 * e1 + e2 * e2 + e3 * e3) + beta;
    const double c0 = W * (e2 - e1), c1 = W * (2 * e3 - e1 - e2);
    const double Pxy0 = a0 * c0, Pxy1 = a1 * c0 + b * c1;
    const double per_Pyy = 1 / Pyy, K0 = Pxy0 * per_Pyy, K1 = Pxy1 * per_Pyy;
    x0 -= K0 * y;
    x1 -= K1 * y;
    P00 -= K0 * Pxy0;
    P10 -= K1 * Pxy0;
    P11 -= K1 * Pxy1;
  }
};

struct StraightLine3 {
  double x0 = 50, x1 = 10, x2 = 1;
  double P00 = 100, P10 = 0, P20 = 0, P11 = 100, P21 = 0, P22 = 100;

  void step(const Sample& s) {
    constexpr double W = 1 / spread2 / 4, Wm0 = 1 - 1 / spread2, Wc0 = Wm0 + 3 - spread2;
    const double z0 = spread * 1.4142135623730951, z1 = spread * 0.8164965809277261,
                 z2 = spread * 0.5773502691896258;
    P00 += alpha * std::abs(x0);
    P11 += alpha * std::abs(x1);
    P22 += alpha * std::abs(x2);
    const double L00 = std::sqrt(P00), L10 = P10 / L00, L20 = P20 / L00;
    const double L11 = std::sqrt(P11 - L10 * L10), L21 = (P21 - L20 * L10) / L11;
    const double L22 = std::sqrt(P22 - L20 * L20 - L21 * L21);
    const double a0 = z0 * L00, a1 = z0 * L10, a2 = z0 * L20;
    const double b1 = z1 * L11, b2 = z1 * L21, c2 = z2 * L22;
    const double r = s.T - s.phi[0] * x0 - s.phi[1] * x1 - s.phi[2] * x2;
    const double first = s.phi[0] * a0 + s.phi[1] * a1 + s.phi[2] * a2;
    const double second = s.phi[1] * b1 + s.phi[2] * b2, third = s.phi[2] * c2;
    const double r1 = r + first + second + third, r2 = r - first + second + third;
    const double r3 = r - 2 * second + third, r4 = r - 3 * third;
    const double y0 = s.w * r * r, y1 = s.w * r1 * r1, y2 = s.w * r2 * r2, y3 = s.w * r3 * r3,
                 y4 = s.w * r4 * r4;
    const double y = Wm0 * y0 + W * (y1 + y2 + y3 + y4);
    const double e0 = y0 - y, e1 = y1 - y, e2 = y2 - y, e3 = y3 - y, e4 = y4 - y;
    const double Pyy = Wc0 * e0 * e0 + W * (e1 * e1 + e2 * e2 + e3 * e3 + e4 * e4) + beta;
    const double u0 = W * (e2 - e1), u1 = W * (2 * e3 - e1 - e2), u2 = W * (3 * e4 - e1 - e2 - e3);
    const double Pxy0 = a0 * u0, Pxy1 = a1 * u0 + b1 * u1, Pxy2 = a2 * u0 + b2 * u1 + c2 * u2;
    const double per_Pyy = 1 / Pyy;
    const double K0 = Pxy0 * per_Pyy, K1 = Pxy1 * per_Pyy, K2 = Pxy2 * per_Pyy;
    x0 -= K0 * y;
    x1 -= K1 * y;
    x2 -= K2 * y;
    P00 -= K0 * Pxy0;
    P10 -= K1 * Pxy0;
    P20 -= K2 * Pxy0;
    P11 -= K1 * Pxy1;
    P21 -= K2 * Pxy1;
    P22 -= K2 * Pxy2;
  }
};

}  // namespace searig::bench
