#pragma once

#include <vector>

#include "knotwork/basis/knot_vector.h"
#include "knotwork/result.h"

namespace knotwork {

/// How many different parameters of data stand on the knots and between them: equal ones count once, for they say the
/// same about which functions the data tell apart. Index s - p belongs to the knot t_s, s = p..last_span(), and to the
/// interval behind it.
struct ParameterCount {
  /// At t_s, 0 or 1; where knots are equal, counted at the last of them. One more at the back: at the end of an open
  /// domain.
  std::vector<int> on;
  /// t_s < x < t_{s+1}. No more than p+1 need be counted: so many functions are not 0 there.
  std::vector<int> inside;
};

/// The Schoenberg-Whitney conditions for the basis functions b_first .. b_last (closed: all of them, first = 0 and
/// last = n-1): there is a different parameter for each that lies inside its support, t_i < x < t_{i+p+1}; the ends of
/// an open domain count as inside the support of the first and of the last function. Open, they hold exactly when these
/// functions are linearly independent on the data; closed, independence needs them, but they do not suffice.
///
/// By Hall's theorem: supports are intervals, neighbours overlap, so they hold exactly when no run of k neighbouring
/// functions has fewer than k parameters inside the union of its supports. Exact; O(n).
/// Error path: `parameters`; the message names the run that misses most.
/// Source: THEORY 2.4; Schoenberg and Whitney, Trans. AMS 74 (1953); Schumaker, Spline Functions, 4.8.
Status check_schoenberg_whitney(const KnotVector& knots, const ParameterCount& count, int first, int last);

}  // namespace knotwork
