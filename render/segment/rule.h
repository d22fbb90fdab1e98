#pragma once
/// The numbers of the rule that separates a body from what it lies on (body_mask.h). Where a gap between tables and
/// bodies was measured, a number lies in the middle of it: in 14 scans the tables and holders that were pieces of their
/// own held balls of 2.0 to 8.9 mm radius, the bodies of 18 to 107 mm.

namespace pdr::segment {

inline constexpr int kRule = 2;          ///< version of the steps and numbers: image files name it
inline constexpr int kSolidHu = -250;    ///< cells above it are solid
inline constexpr double kBallMm = 10;    ///< radius of the ball that every body holds and no table does
inline constexpr double kOpeningMm = 3;  ///< parts thinner than twice this may be foreign
/// Share of a body that the opening must leave, or else nothing is cut from it.
inline constexpr double kLeastOpened = 0.85;
inline constexpr double kResidueMl = 1;   ///< smaller pieces of the opening's residue stay
inline constexpr double kResidueMm = 60;  ///< shorter pieces stay too
inline constexpr int kSeenHu = -300;      ///< voxels above it count in the hidden volume
inline constexpr int kMetalHu = 2500;     ///< metal outside the body: it may be a frame or an instrument, and stays

inline constexpr double kCoarsestMm = 5;   ///< largest voxel spacing: beyond, tables and skin are one
inline constexpr double kLeastBody = 0.5;  ///< least share of the solid cells that are bodies
/// Largest share of the border at the patient's sides that the body may cover.
inline constexpr double kMostAtBorder = 0.3;

}  // namespace pdr::segment
