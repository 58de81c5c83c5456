#pragma once

#include <string>
#include <variant>
#include <vector>

#include "knotwork/scene/document.h"
#include "knotwork/scene/net_edits.h"
#include "knotwork/scene/parameters.h"

namespace knotwork::scene {

struct SetParameter {
  std::string id;
  ParameterValue value;
};
/// Replaces the edit of one patch; an identity edit removes it.
struct SetPatchEdit {
  PatchIndex patch;
  PatchEdit edit;
};
struct ResetPatches {};
/// The same for the local curves of a blending curve.
struct SetLocalEdit {
  int local;
  PatchEdit edit;
};
struct ResetLocals {};
/// A point of the curve on the stage; what its knots do is said in curve_edits.h.
struct SetPoint {
  int index;
  Eigen::Vector3d position;
};
/// All points of what is made from a list of them: the data of a fitted curve, the polygon of a subdivision.
struct SetPoints {
  std::vector<Eigen::Vector3d> points;
};
struct InsertPoint {
  int index;  ///< of the new point
  Eigen::Vector3d position;
};
struct RemovePoint {
  int index;
};
/// Knot t_index of the B-spline curve or blending curve on the stage.
struct SetKnot {
  int index;
  double value;
};
/// A point of the net on the stage; what the others do to it is said in net_edits.h.
struct SetNetPoint {
  PatchIndex point;
  Eigen::Vector3d position;
};
struct InsertNetLine {
  NetDirection direction;
  double at;
};
struct RemoveNetLine {
  NetDirection direction;
  int index;
};
struct SetNetKnot {
  NetDirection direction;
  int index;
  double value;
};
struct SetCamera {
  Camera camera;
};
struct LoadDocument {
  Document document;
};
/// The clock moves on by `seconds` of real time; only while playing.
struct AdvanceClock {
  double seconds;
};

using Command = std::variant<SetParameter, SetPatchEdit, ResetPatches, SetPoint, InsertPoint, RemovePoint, SetKnot,
                             SetCamera, LoadDocument, AdvanceClock, SetPoints, SetLocalEdit, ResetLocals, SetNetPoint,
                             InsertNetLine, RemoveNetLine, SetNetKnot>;

/// The only way a document changes. On an error nothing has changed.
Status apply(Document& document, const Command& command);

/// Whether undo takes this command back: not the camera's, not the clock's.
bool in_history(const Command& command);
/// A few words for a reader: "Close u", "Move patch 2, 1".
std::string describe(const Command& command);
/// What the command changes beside what it names, as a sentence for the reader; empty when nothing. To be asked before
/// the command is applied.
std::string notice(const Document& document, const Command& command);

}  // namespace knotwork::scene
