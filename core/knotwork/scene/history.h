#pragma once

#include <string>
#include <vector>

#include "knotwork/scene/commands.h"

namespace knotwork::scene {

/// Applies commands to a document and takes them back, exactly. Undo restores objects, what is shown and the
/// animation's settings; camera and clock stay as they are, except where a whole document was loaded.
class History {
 public:
  /// Applies and records. Commands between begin_gesture and end_gesture form one entry (a drag); an entry that leaves
  /// the document as it was is dropped. Oldest entries go when there are more than 256 or they hold over 32 MiB.
  Status perform(Document& document, const Command& command);
  void begin_gesture();
  void end_gesture();
  /// Ends the gesture and puts the document back as it was before it (Escape during a drag).
  void cancel_gesture(Document& document);

  bool can_undo() const;
  bool can_redo() const;
  std::string undo_label() const;
  std::string redo_label() const;
  /// False when there is nothing to undo (redo).
  bool undo(Document& document);
  bool redo(Document& document);

 private:
  struct Entry {
    Document before, after;
    std::string label;
    bool whole_document;
  };
  std::vector<Entry> done_, undone_;
  bool in_gesture_ = false;
  bool gesture_recorded_ = false;  ///< the open gesture already has its entry
};

}  // namespace knotwork::scene
