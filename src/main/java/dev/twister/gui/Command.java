package dev.twister.gui;

import java.util.Locale;
import javafx.scene.input.KeyCombination;

/** What a person can do by a menu or a key; the one place that says which key. */
enum Command {
    OPEN(Group.FILE, "Open…", "Shortcut+O", "Opens a scene or a mesh, or a panorama as the sky."),
    SAVE(Group.FILE, "Save", "Shortcut+S", "Saves the scene, with the camera where it is now."),
    SAVE_AS(Group.FILE, "Save as…", "Shortcut+Shift+S", "Saves the scene under another name."),
    SCREENSHOT(Group.FILE, "Screenshot…", "F12", "Saves the picture as PNG, or as HDR with its radiance."),
    RECORD(Group.FILE, "Record…", "Shortcut+R", "Saves each picture drawn as a numbered PNG, until chosen again."),
    QUIT(Group.FILE, "Quit", "Shortcut+Q", "Closes the window."),
    UNDO(Group.EDIT, "Undo", "Shortcut+Z", "Takes the last edit back."),
    REDO(Group.EDIT, "Redo", "Shortcut+Shift+Z", "Makes the edit again that was taken back."),
    REDO_ALSO(Group.EDIT, "Redo", "Shortcut+Y", "As Ctrl+Shift+Z."),
    INSERT(Group.EDIT, "Insert sphere", "Insert", "A new sphere in the middle of the picture."),
    INSERT_MESH(Group.EDIT, "Insert mesh…", "Shift+Insert", "Adds a mesh file to the scene, as large as a new sphere."),
    DUPLICATE(Group.EDIT, "Duplicate", "Shortcut+D", "Another sphere or mesh like the selected one, beside it."),
    COPY(Group.EDIT, "Copy", "Shortcut+C", "Copies the selected sphere or mesh."),
    PASTE(
            Group.EDIT,
            "Paste",
            "Shortcut+V",
            "Inserts the copied sphere or mesh beside the original, also in another scene."),
    DELETE(Group.EDIT, "Delete", "Delete", "Deletes the selected sphere or mesh."),
    NEXT(Group.EDIT, "Next body", "F2", "Selects the light, the plane, then each sphere and each mesh, then nothing."),
    PREVIOUS(Group.EDIT, "Previous body", "Shift+F2", "The same the other way round."),
    DESELECT(Group.EDIT, "Back to the picture", "Esc", "Leaves the panel; in the picture, selects nothing."),
    RESET(Group.EDIT, "Reset everything", "Shortcut+Shift+Home", "Everything in the panel as it was at first."),
    NEXT_SHOWN(Group.VIEW, "Next stage or view", "F4", "Shows the next stage of the picture, or the next view."),
    PREVIOUS_SHOWN(Group.VIEW, "Previous stage or view", "Shift+F4", "The same the other way round."),
    INSPECT(Group.VIEW, "Pixel inspector", "Shortcut+I", "Shows what the pixel under the pointer is."),
    EXPLAIN(
            Group.VIEW,
            "Path of a pixel",
            "Shortcut+P",
            "Shows the rays of the pixel under the pointer; so does Alt+click."),
    COMPARE(
            Group.VIEW,
            "Second picture",
            "Shortcut+K",
            "Splits the view: another engine, stage or settings at the right."),
    ZOOM_IN(Group.VIEW, "Zoom in", "Shortcut+EQUALS", "Magnifies the picture; so does Ctrl and the wheel."),
    ZOOM_OUT(Group.VIEW, "Zoom out", "Shortcut+MINUS", "The same the other way round."),
    ZOOM_TO_FIT(Group.VIEW, "Zoom to fit", "Shortcut+Backspace", "Shows all of the picture again."),
    FRAME(Group.VIEW, "Frame selected", "PERIOD", "Moves the camera so that the selected body fills the picture."),
    FRAME_ALSO(Group.VIEW, "Frame selected", "DECIMAL", "As the period."),
    Q_UP(Group.VIEW, "Q up, E down", "Shortcut+E", "Swaps the keys that lead up and down."),
    PANEL(Group.VIEW, "Panel", "F9", "Shows or hides the panel; so does Tab, in the picture."),
    FRAME_TIMES(Group.VIEW, "Frame times", "F3", "Shows or hides frames a second and their graph."),
    FULL_SCREEN(Group.VIEW, "Full screen", "F11", "The window fills the screen, or no longer."),
    MOVE(Group.PHYSICS, "Physics on or off", "F5", "Lets bodies fall and collide, or puts them back."),
    PAUSE(Group.PHYSICS, "Pause", "F6", "Stops the time of moving bodies, or lets it go on."),
    STEP(Group.PHYSICS, "Step", "F7", "Lets 1/120 of a second pass, and stops."),
    RANDOMIZE(Group.PHYSICS, "Randomize", "F8", "Throws the spheres into the air, anywhere over the plane."),
    PLAY(Group.FILM, "Play", "SPACE", "Moves the camera along its keyframes, from the present time; stops it."),
    SET_KEYFRAME(Group.FILM, "Set keyframe", "K", "Makes the camera as it is now a keyframe of the present time."),
    DELETE_KEYFRAME(Group.FILM, "Delete keyframe", "Shift+K", "Deletes the keyframe of the present time."),
    NEXT_KEYFRAME(Group.FILM, "Next keyframe", "Page Down", "Goes to the next keyframe."),
    PREVIOUS_KEYFRAME(Group.FILM, "Previous keyframe", "Page Up", "Goes to the keyframe before."),
    FILM(Group.FILM, "Keyframes", "Shortcut+T", "Shows or hides the keyframes of the camera, below the picture."),
    CONTROLS(Group.HELP, "Controls", "F1", "Shows this list."),
    ABOUT(Group.HELP, "About Twister", "Shift+F1", "Says which version this is.");

    /** The menus, in their order. */
    enum Group {
        FILE,
        EDIT,
        VIEW,
        PHYSICS,
        FILM,
        HELP;

        String label() {
            return name().charAt(0) + name().substring(1).toLowerCase(Locale.ROOT);
        }
    }

    private final Group group;
    private final String label;
    private final String keys;
    private final String hint;

    Command(Group group, String label, String keys, String hint) {
        this.group = group;
        this.label = label;
        this.keys = keys;
        this.hint = hint;
    }

    Group group() {
        return group;
    }

    String label() {
        return label;
    }

    KeyCombination keys() {
        return KeyCombination.valueOf(keys);
    }

    String hint() {
        return hint;
    }
}
