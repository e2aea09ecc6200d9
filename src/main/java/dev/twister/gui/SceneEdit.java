package dev.twister.gui;

import dev.twister.scene.Scene;
import java.util.function.UnaryOperator;

/** How a control's changes reach the studio. */
interface SceneEdit {
    /** Makes a change; successive ones of the same name belong together until {@link #endGesture}. */
    void apply(String what, UnaryOperator<Scene> change);

    void endGesture();

    /** Changes that can be undone. */
    static SceneEdit ofScene(Studio studio) {
        return new SceneEdit() {
            @Override
            public void apply(String what, UnaryOperator<Scene> change) {
                studio.edit(what, change);
            }

            @Override
            public void endGesture() {
                studio.endGesture();
            }
        };
    }

    /** Changes of the camera, which are the viewer's and no edits. */
    static SceneEdit ofCamera(Studio studio) {
        return new SceneEdit() {
            @Override
            public void apply(String what, UnaryOperator<Scene> change) {
                studio.moveCamera(_ -> change.apply(studio.scene()).camera());
            }

            @Override
            public void endGesture() {
                // Nothing to undo, so nothing to end.
            }
        };
    }
}
