#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "knotwork/scene/commands.h"

namespace knotwork::scene {

/// Applies commands to a document and takes them back, exactly. Undo restores objects, what is shown and the
/// animation's settings; camera and clock stay as they are, except where a whole document was loaded.
class History {
 public:
  static constexpr std::size_t max_entries = 256, max_bytes = 32u << 20;

  /// Applies and records. Commands between begin_gesture and end_gesture form one entry (a drag); an entry that leaves
  /// the document as it was is dropped. Oldest entries go when there are more than max_entries or they hold more than
  /// max_bytes; the latest always stays.
  Status perform(Document& document, const Command& command);
  void begin_gesture();
  void end_gesture();
  /// Ends the gesture and puts the document back as it was before it (Escape during a drag).
  void cancel_gesture(Document& document);

  bool can_undo() const { return !done_.empty(); }
  bool can_redo() const { return !undone_.empty(); }
  /// Empty when there is nothing to undo (redo).
  std::string undo_label() const { return can_undo() ? done_.back().label : std::string(); }
  std::string redo_label() const { return can_redo() ? undone_.back().label : std::string(); }
  /// False when there is nothing to undo (redo). An open gesture ends first.
  bool undo(Document& document);
  bool redo(Document& document);

 private:
  /// A state to go back (or forward) to: only the side that the document is not on needs to be kept.
  struct Entry {
    Document state;
    std::string label;
    bool whole_document;  ///< camera and clock too
  };

  void shorten();

  std::deque<Entry> done_;
  std::vector<Entry> undone_;
  bool in_gesture_ = false;
  bool gesture_recorded_ = false;  ///< the open gesture's entry is done_.back()
  bool gesture_changed_ = false;   ///< the document now differs from that entry's state
};

}  // namespace knotwork::scene
