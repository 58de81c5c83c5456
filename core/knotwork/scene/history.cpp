#include "knotwork/scene/history.h"

#include <algorithm>

#include "knotwork/scene/blending_curve_edits.h"
#include "knotwork/scene/curve_edits.h"

namespace knotwork::scene {

namespace {

/// What undo restores without a whole document.
void restore(Document& document, const Document& state, bool whole_document) {
  const Camera camera = document.camera;
  const bool playing = document.animation.playing;
  const double time = document.animation.time;
  document = state;
  if (whole_document) return;
  document.camera = camera;
  document.animation.playing = playing;
  document.animation.time = time;
}

bool restoring_changes(const Document& document, const Document& state, bool whole_document) {
  if (whole_document) return document != state;
  Animation animation = state.animation;
  animation.playing = document.animation.playing;
  animation.time = document.animation.time;
  return document.objects != state.objects || document.display != state.display || document.animation != animation;
}

/// Memory held, nearly: maps cost about four words a node beside their values.
std::size_t bytes(const Document& document) {
  std::size_t sum = sizeof document;
  for (const Object& object : document.objects) {
    sum += sizeof object + object.id.size() + object.label.size();
    if (const auto* edits = local_edits(object.shape))
      sum += edits->size() * (sizeof(std::pair<PatchIndex, PatchEdit>) + 4 * sizeof(void*));
    else if (const auto* spline = std::get_if<BSplineSurfaceObject>(&object.shape))
      sum += spline->net.size() *
             (sizeof(std::vector<Eigen::Vector3d>) + spline->net.front().size() * sizeof(Eigen::Vector3d));
    else
      sum += curve_points(object.shape).size() * 2 * sizeof(Eigen::Vector3d);  // knots are fewer than points by far
  }
  return sum;
}

}  // namespace

Status History::perform(Document& document, const Command& command) {
  if (!in_history(command)) return apply(document, command);

  const bool whole = std::holds_alternative<LoadDocument>(command);
  if (in_gesture_ && gesture_recorded_) {
    Status status = apply(document, command);
    Entry& entry = done_.back();
    if (status) {
      entry.label = describe(command);
      entry.whole_document = entry.whole_document || whole;
      gesture_changed_ = restoring_changes(document, entry.state, entry.whole_document);
    }
    return status;
  }

  Document before = document;
  if (Status status = apply(document, command); !status) return status;
  const bool changed = restoring_changes(document, before, whole);
  if (!changed && !in_gesture_) return success();
  done_.push_back({std::move(before), describe(command), whole});
  if (in_gesture_) {
    gesture_recorded_ = true;
    gesture_changed_ = changed;
  } else {
    undone_.clear();
    shorten();
  }
  return success();
}

void History::begin_gesture() {
  end_gesture();
  in_gesture_ = true;
}

void History::end_gesture() {
  if (gesture_recorded_) {
    if (gesture_changed_) {
      undone_.clear();
      shorten();
    } else {
      done_.pop_back();
    }
  }
  in_gesture_ = gesture_recorded_ = gesture_changed_ = false;
}

void History::cancel_gesture(Document& document) {
  if (gesture_recorded_) {
    restore(document, done_.back().state, done_.back().whole_document);
    done_.pop_back();
  }
  in_gesture_ = gesture_recorded_ = gesture_changed_ = false;
}

bool History::undo(Document& document) {
  end_gesture();
  if (done_.empty()) return false;
  Entry entry = std::move(done_.back());
  done_.pop_back();
  Document now = document;
  restore(document, entry.state, entry.whole_document);
  undone_.push_back({std::move(now), std::move(entry.label), entry.whole_document});
  return true;
}

bool History::redo(Document& document) {
  end_gesture();
  if (undone_.empty()) return false;
  Entry entry = std::move(undone_.back());
  undone_.pop_back();
  Document now = document;
  restore(document, entry.state, entry.whole_document);
  done_.push_back({std::move(now), std::move(entry.label), entry.whole_document});
  return true;
}

void History::shorten() {
  std::size_t sum = 0, kept = 0;
  for (auto entry = done_.rbegin(); entry != done_.rend(); ++entry) {
    sum += bytes(entry->state);
    if (kept > 0 && (kept == max_entries || sum > max_bytes)) break;
    ++kept;
  }
  done_.erase(done_.begin(), done_.end() - static_cast<std::ptrdiff_t>(kept));
}

}  // namespace knotwork::scene
