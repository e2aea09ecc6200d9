package dev.twister.gui.studio;

import dev.twister.gui.edit.TagEdits;
import dev.twister.scene.Scene;
import dev.twister.scene.select.Tag;
import java.util.Collection;
import java.util.List;
import java.util.function.UnaryOperator;

/** Names, groups, hides and locks bodies. */
public final class TagActions {
    private static final String LAST_LIGHT = "The last visible light can't be hidden; a scene has at least one";

    private final Studio studio;

    public TagActions(Studio studio) {
        this.studio = studio;
    }

    /** Hides the selected bodies. */
    public void hide() {
        setHidden(selected(), true);
    }

    /** Shows all hidden bodies. */
    public void showAll() {
        List<Integer> hidden = TagEdits.having(studio.scene(), Tag::hidden);
        setHidden(hidden, false);
        studio.notice(hidden.isEmpty() ? "Nothing is hidden" : count(hidden) + " shown");
    }

    public void setHidden(Collection<Integer> bodies, boolean hidden) {
        if (!hidden) {
            edit("show bodies", bodies, tag -> tag.withHidden(false));
        } else {
            List<Integer> hideable = TagEdits.hideable(studio.scene(), bodies);
            edit("hide bodies", hideable, tag -> tag.withHidden(true));
            if (hideable.size() < bodies.size()) {
                studio.notice(bodies.isEmpty() ? "Nothing is selected" : LAST_LIGHT);
            }
        }
    }

    /** Locks the selected bodies, or frees them if all are locked. */
    public void toggleLock() {
        Collection<Integer> bodies = selected();
        boolean locked = bodies.stream()
                .allMatch(body -> TagEdits.of(studio.scene(), body).locked());
        setLocked(bodies, !locked);
        studio.notice(bodies.isEmpty() ? "Nothing is selected" : count(bodies) + (locked ? " unlocked" : " locked"));
    }

    public void setLocked(Collection<Integer> bodies, boolean locked) {
        edit(locked ? "lock bodies" : "unlock bodies", bodies, tag -> tag.withLocked(locked));
    }

    /** Puts the selected bodies into a new group. */
    public void group() {
        String name = TagEdits.newGroup(studio.scene());
        Collection<Integer> bodies = selected();
        edit("group bodies", bodies, tag -> tag.withGroup(name));
        studio.notice(bodies.isEmpty() ? "Nothing is selected" : count(bodies) + " in " + name);
    }

    /** Takes the selected bodies out of their groups. */
    public void ungroup() {
        edit("ungroup bodies", selected(), tag -> tag.withGroup(""));
    }

    /** Selects all bodies of the active body's group; tells it if it has none. */
    public void selectGroup() {
        Scene scene = studio.scene();
        String group = TagEdits.of(scene, studio.selection().active()).group();
        if (group.isEmpty()) {
            studio.notice("Select a body of a group first");
        } else {
            studio.selection().select(TagEdits.members(scene, group));
        }
    }

    public void rename(int body, String name) {
        edit("rename", List.of(body), tag -> tag.withName(name));
    }

    public void renameGroup(String group, String name) {
        edit("rename group", TagEdits.members(studio.scene(), group), tag -> tag.withGroup(name));
    }

    private Collection<Integer> selected() {
        return studio.selection().bodies().bodies();
    }

    private static String count(Collection<Integer> bodies) {
        return bodies.size() == 1 ? "1 body" : bodies.size() + " bodies";
    }

    private void edit(String what, Collection<Integer> bodies, UnaryOperator<Tag> change) {
        Scene edited = TagEdits.edited(studio.scene(), bodies, change);
        if (!TagEdits.areSame(edited, studio.scene())) {
            studio.endGesture();
            studio.editOnce(what, scene -> TagEdits.edited(scene, bodies, change));
        }
    }
}
