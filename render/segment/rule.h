#pragma once
/// The numbers of the rule that tells a body from what it lies on (body_mask.h). Where a factor between tables and
/// bodies was measured, a number lies in its middle: of 14 scans the tables and holders that were pieces of their own
/// held balls of 2.0 to 8.9 mm radius, the bodies of 18 to 107 mm.

namespace pdr::segment {

inline constexpr int kRule = 2;               ///< which set of steps and numbers this is: pictures name it
inline constexpr int kSolidHu = -250;         ///< above it a cell is solid
inline constexpr double kBallMm = 10;         ///< radius of the ball that every body holds and no table
inline constexpr double kOpeningMm = 3;       ///< what is thinner than twice this may be foreign
inline constexpr double kLeastOpened = 0.85;  ///< of a body that is left by the opening, or else nothing is cut from it
inline constexpr double kResidueMl = 1;       ///< smaller pieces of what the opening leaves over stay
inline constexpr double kResidueMm = 60;      ///< and shorter ones
inline constexpr int kSeenHu = -300;          ///< what is hidden counts from here on
inline constexpr int kMetalHu = 2500;         ///< outside the body: it may be a frame or an instrument, and stays

inline constexpr double kCoarsestMm = 5;      ///< between voxels: beyond, tables and skin are one
inline constexpr double kLeastBody = 0.5;     ///< of what is solid
inline constexpr double kMostAtBorder = 0.3;  ///< of the border, beside the patient, that the body may cover

}  // namespace pdr::segment
