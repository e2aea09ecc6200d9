package dev.twister.gui.edit;

import java.util.Optional;

/**
 * What can be done about the edits of a scene.
 *
 * @param undoable the edit that undo takes back
 * @param redoable the edit that redo makes again
 * @param changed whether there is something to save
 */
public record EditState(Optional<String> undoable, Optional<String> redoable, boolean changed) {
    /** A scene as its file has it. */
    public static final EditState UNTOUCHED = new EditState(Optional.empty(), Optional.empty(), false);

    public static EditState of(SceneHistory history) {
        return new EditState(history.undoable(), history.redoable(), history.hasChanged());
    }
}
