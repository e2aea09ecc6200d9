package dev.twister.gui.controls;

import java.util.Locale;
import javafx.scene.input.KeyCombination;

/** The commands of menus and keys, in the order of the menus, with their keys, labels and hints. */
public enum Command {
    NEW(Group.FILE, "New", "Shortcut+N", "A new scene: a floor, a sky and a light."),
    GALLERY(Group.FILE, "Gallery…", "Shortcut+Shift+O", "Shows the shipped and recent scenes as pictures."),
    OPEN(Group.FILE, "Open…", "Shortcut+O", "Opens a scene or a mesh, or a panorama as the sky."),
    VIEW_PICTURE(
            Group.FILE,
            "View picture…",
            "Shortcut+Shift+P",
            "Shows a PNG, HDR or EXR file, with its light layers, and compares it with the rendering."),
    SAVE(Line.ABOVE, Group.FILE, "Save", "Shortcut+S", "Saves the scene, with the camera where it is now."),
    SAVE_AS(Group.FILE, "Save as…", "Shortcut+Shift+S", "Saves the scene under another name."),
    TITLE(
            Group.FILE,
            "Name and description…",
            "Shortcut+Shift+D",
            "Edits what the scene is called and says of itself."),
    SCREENSHOT(
            Line.ABOVE, Group.FILE, "Screenshot…", "F12", "Saves the picture as PNG, or its radiance as HDR or EXR."),
    RENDER(Group.FILE, "Render to file…", "Shift+F12", "Renders a picture or a film, beside the window."),
    RECORD(Group.FILE, "Record…", "Shortcut+R", "Saves each picture drawn as a numbered PNG, until chosen again."),
    QUIT(Line.ABOVE, Group.FILE, "Quit", "Shortcut+Q", "Closes the window."),
    UNDO(Group.EDIT, "Undo", "Shortcut+Z", "Undoes the last edit."),
    REDO(Group.EDIT, "Redo", "Shortcut+Shift+Z", "Redoes the last undone edit."),
    REDO_ALSO(Group.EDIT, "Redo", "Shortcut+Y", "Same as Ctrl+Shift+Z."),
    DUPLICATE(
            Line.ABOVE,
            Group.EDIT,
            "Duplicate",
            "Shortcut+D",
            "Adds copies of the selected bodies and lights beside them."),
    COPY(Group.EDIT, "Copy", "Shortcut+C", "Copies the selected spheres, meshes and lights."),
    PASTE(Group.EDIT, "Paste", "Shortcut+V", "Inserts what was copied beside the originals, also in another scene."),
    DELETE(Group.EDIT, "Delete", "Delete", "Deletes the selected spheres, meshes and lights."),
    DROP(Group.EDIT, "Drop to the ground", "End", "Puts the selected spheres and meshes on the ground."),
    GRAB(
            Line.ABOVE,
            Group.EDIT,
            "Move",
            "G",
            "Moves the selected bodies with the pointer; X, Y, Z or a number make it exact."),
    ROTATE(Group.EDIT, "Rotate", "R", "Rotates the selected bodies with the pointer, or by a typed angle."),
    SCALE(Group.EDIT, "Scale", "Shift+R", "Scales the selected bodies with the pointer, or by a typed factor."),
    SELECT_ALL(Group.SELECT, "Select all", "Shortcut+A", "Selects all spheres, meshes and lights."),
    INVERT(Group.SELECT, "Invert selection", "Shortcut+Shift+A", "Selects what is not selected."),
    SAME_MATERIAL(Group.SELECT, "Select same material", "Shift+M", "Selects all bodies of the active one's material."),
    BOX(Group.SELECT, "Box selection", "B", "Selects the bodies in a box that is dragged over the picture."),
    NEXT(
            Line.ABOVE,
            Group.SELECT,
            "Next body",
            "F2",
            "Selects each light, the plane, then each sphere and each mesh, then nothing."),
    PREVIOUS(Group.SELECT, "Previous body", "Shift+F2", "Selects them in reverse order."),
    DESELECT(Group.SELECT, "Back to the picture", "Esc", "Leaves the panel; in the picture, selects nothing."),
    HIDE(Line.ABOVE, Group.EDIT, "Hide", "H", "Hides the selected bodies and lights: they are not rendered."),
    SHOW_ALL(Group.EDIT, "Show hidden", "Shift+H", "Shows all hidden bodies and lights."),
    LOCK(Group.EDIT, "Lock or unlock", "Shortcut+L", "Keeps the selected bodies from clicks, moves and deletion."),
    GROUP(Group.EDIT, "Group", "Shortcut+G", "Lists the selected bodies under a heading of their own."),
    UNGROUP(Group.EDIT, "Ungroup", "Shortcut+Shift+G", "Takes the selected bodies out of their groups."),
    SELECT_GROUP(Group.SELECT, "Select group", "Shift+G", "Selects all bodies of the active one's group."),
    AUTO_EXPOSURE(Group.EDIT, "Auto exposure", "Shift+J", "Sets the exposure by the brightness of the picture."),
    RESET(Line.ABOVE, Group.EDIT, "Reset everything", "Shortcut+Shift+Home", "Resets all settings in the panel."),
    INSERT(Group.ADD, "Sphere", "Insert", "A new sphere on the ground in the middle of the picture."),
    INSERT_LIGHT(Line.ABOVE, Group.ADD, "Light", "Shortcut+Insert", "A new light over the middle of the picture."),
    INSERT_SUN(Group.ADD, "Sun", "Alt+Insert", "A new sun, which shines on everything from one direction."),
    INSERT_SPOT(Group.ADD, "Spot", "Shortcut+Alt+Insert", "A new light that shines down in a cone, over the middle."),
    INSERT_MESH(Group.ADD, "Mesh file…", "Shift+Insert", "Adds a mesh file to the scene, as large as a new sphere."),
    NEXT_SHOWN(Group.VIEW, "Next stage or view", "F4", "Shows the next stage of the picture, or the next view."),
    PREVIOUS_SHOWN(Group.VIEW, "Previous stage or view", "Shift+F4", "Shows the previous stage or view."),
    INSPECT(Line.ABOVE, Group.VIEW, "Pixel inspector", "Shortcut+I", "Shows what the pixel under the pointer is."),
    EXPLAIN(
            Group.VIEW,
            "Path of a pixel",
            "Shortcut+P",
            "Shows the rays of the pixel under the pointer; so does Alt+click, unless the system takes it."),
    COMPARE(
            Group.VIEW,
            "Second picture",
            "Shortcut+K",
            "Splits the view: another engine, stage or settings at the right."),
    CLIPPING(Group.VIEW, "Show clipping", "J", "Marks pixels with a channel at 255 in red, and black ones in blue."),
    ZOOM_IN(Group.VIEW, "Zoom in", "Shortcut+EQUALS", "Magnifies the picture; so does Ctrl and the wheel."),
    ZOOM_OUT(Group.VIEW, "Zoom out", "Shortcut+MINUS", "Shows more of the picture."),
    ZOOM_TO_FIT(Group.VIEW, "Zoom to fit", "Shortcut+Backspace", "Shows all of the picture again."),
    FRAME(
            Line.ABOVE,
            Group.VIEW,
            "Frame selected",
            "PERIOD",
            "Moves the camera so that the selected bodies fill the picture."),
    FRAME_ALSO(Group.VIEW, "Frame selected", "DECIMAL", "Same as the period key."),
    Q_UP(Group.VIEW, "Q up, E down", "Shortcut+E", "Swaps the keys for up and down."),
    AXIS_HANDLES(
            Group.VIEW, "Axis handles", "Shift+F3", "Shows or hides the handles that move, rotate and scale bodies."),
    PANEL(Line.ABOVE, Group.VIEW, "Panel", "F9", "Shows or hides the panel."),
    FLOAT_PANEL(Group.VIEW, "Float panel", "Shift+F9", "Moves the panel into a window of its own, or back."),
    SAFE_FRAME(Group.VIEW, "Safe frame", "Shift+F11", "Outlines what a picture of the scene's own size shows."),
    LOCK_CAMERA(Group.VIEW, "Lock camera", "Shift+L", "Keeps the camera where it is, but for views and keyframes."),
    FRAME_TIMES(Group.VIEW, "Frame times", "F3", "Shows or hides frames per second and their graph."),
    FULL_SCREEN(Line.ABOVE, Group.VIEW, "Full screen", "F11", "Toggles full screen."),
    MOVE(Group.PHYSICS, "Physics on or off", "F5", "Starts the physics, or resets the bodies."),
    PAUSE(Group.PHYSICS, "Pause", "F6", "Pauses or resumes the physics."),
    STEP(Group.PHYSICS, "Step", "F7", "Advances the physics by 1/120 s and pauses."),
    RANDOMIZE(
            Line.ABOVE, Group.PHYSICS, "Randomize", "F8", "Throws the spheres into the air, anywhere over the plane."),
    PLAY(Group.FILM, "Play", "SPACE", "Plays or stops the keyframes."),
    SET_KEYFRAME(Line.ABOVE, Group.FILM, "Set keyframe", "K", "Sets a keyframe of the camera at the current time."),
    DELETE_KEYFRAME(Group.FILM, "Delete keyframe", "Shift+K", "Deletes the camera's keyframe at the current time."),
    SET_KEYFRAME_OF(
            Group.FILM,
            "Set keyframe of…",
            "I",
            "Sets a keyframe of the selected bodies or lights, the lens, the sky or the exposure."),
    DELETE_KEYFRAME_OF(
            Group.FILM,
            "Delete keyframe of selected",
            "Shift+I",
            "Deletes the keyframes of the selected bodies and lights at the current time."),
    NEXT_KEYFRAME(Line.ABOVE, Group.FILM, "Next keyframe", "Page Down", "Goes to the next keyframe."),
    PREVIOUS_KEYFRAME(Group.FILM, "Previous keyframe", "Page Up", "Goes to the previous keyframe."),
    FILM(Line.ABOVE, Group.FILM, "Keyframes", "Shortcut+T", "Shows or hides the keyframes, below the picture."),
    CONTROLS(Group.HELP, "Controls", "F1", "Shows this list."),
    ABOUT(Line.ABOVE, Group.HELP, "About Twister", "Shift+F1", "Shows the version.");

    /** The menus, in their order. */
    public enum Group {
        FILE,
        EDIT,
        SELECT,
        ADD,
        VIEW,
        PHYSICS,
        FILM,
        HELP;

        public String label() {
            return name().charAt(0) + name().substring(1).toLowerCase(Locale.ROOT);
        }
    }

    /** Separates a command from the one before it in the menu. */
    private enum Line {
        ABOVE
    }

    private final boolean belowLine;
    private final Group group;
    private final String label;
    private final String keys;
    private final String hint;

    Command(Group group, String label, String keys, String hint) {
        this(false, group, label, keys, hint);
    }

    Command(Line line, Group group, String label, String keys, String hint) {
        this(line == Line.ABOVE, group, label, keys, hint);
    }

    Command(boolean belowLine, Group group, String label, String keys, String hint) {
        this.belowLine = belowLine;
        this.group = group;
        this.label = label;
        this.keys = keys;
        this.hint = hint;
    }

    /** Whether a line separates it from the command before it in the menu. */
    public boolean isBelowLine() {
        return belowLine;
    }

    /** Whether it is another key of the command before it, which needs no second line in the menu. */
    public boolean isSecondKey() {
        return this == REDO_ALSO || this == FRAME_ALSO;
    }

    public Group group() {
        return group;
    }

    public String label() {
        return label;
    }

    public KeyCombination keys() {
        return KeyCombination.valueOf(keys);
    }

    public String hint() {
        return hint;
    }
}
