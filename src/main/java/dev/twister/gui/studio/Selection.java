package dev.twister.gui.studio;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import java.util.Collection;
import java.util.function.Consumer;
import javafx.beans.property.ReadOnlyIntegerProperty;
import javafx.beans.property.ReadOnlyIntegerWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** The selected bodies. Several at a time must be movable; the plane or a poured sphere is selected alone. */
public final class Selection {
    private final Document document;
    private final Consumer<String> notice;
    private final ReadOnlyObjectWrapper<SelectedBodies> bodies = new ReadOnlyObjectWrapper<>(SelectedBodies.NONE);
    private final ReadOnlyIntegerWrapper active = new ReadOnlyIntegerWrapper(BodyNumber.NONE);

    Selection(Document document, Consumer<String> notice) {
        this.document = document;
        this.notice = notice;
    }

    public ReadOnlyObjectProperty<SelectedBodies> bodiesProperty() {
        return bodies.getReadOnlyProperty();
    }

    public SelectedBodies bodies() {
        return bodies.get();
    }

    /** See {@link SelectedBodies#active}; changes after {@link #bodiesProperty}. */
    public ReadOnlyIntegerProperty activeProperty() {
        return active.getReadOnlyProperty();
    }

    public int active() {
        return bodies.get().active();
    }

    /** Selects one body: a light, the plane, a sphere, a mesh or a poured sphere; any other number selects nothing. */
    public void select(int body) {
        set(SelectedBodies.of(BodyEdits.isSelectable(document.scene(), body) ? body : BodyNumber.NONE));
    }

    /** Selects the movable ones of several bodies, the last of them active; a single one as {@link #select(int)}. */
    public void select(Collection<Integer> several) {
        if (several.size() == 1) {
            select(several.iterator().next());
        } else {
            set(SelectedBodies.of(several.stream().filter(this::isMovable).toList()));
        }
    }

    /** Adds a body to the selection and makes it active, or removes it; tells it if it can only be selected alone. */
    public void toggle(int body) {
        SelectedBodies selected = bodies.get();
        boolean movable = isMovable(body);
        if (movable || selected.contains(body)) {
            set((movable ? selected.where(this::isMovable) : selected).toggled(body));
        } else if (BodyEdits.isSelectable(document.scene(), body)) {
            if (selected.where(this::isMovable).count() == 0) {
                select(body);
            } else {
                notice.accept((body == BodyNumber.PLANE ? "The plane" : "A poured sphere") + " is only selected alone");
            }
        }
    }

    /** Makes one of the selected bodies the active one. */
    public void activate(int body) {
        set(bodies.get().withActive(body));
    }

    /** Selects all movable bodies; the active one stays active. */
    public void selectAll() {
        SelectedBodies all = SelectedBodies.of(BodyEdits.movable(document.scene()));
        set(all.contains(active()) ? all.withActive(active()) : all);
        notice.accept(all.count() + " bodies selected");
    }

    /** Selects all movable bodies that are not selected, and no others. */
    public void invert() {
        set(SelectedBodies.of(BodyEdits.movable(document.scene()).stream()
                .filter(body -> !bodies.get().contains(body))
                .toList()));
        notice.accept(bodies.get().count() + " bodies selected");
    }

    /** Selects all spheres and meshes of the active body's material; tells it if it has none. */
    public void selectSameMaterial() {
        Scene scene = document.scene();
        if (!BodyMaterials.has(scene, active())) {
            notice.accept("Select a sphere, or a mesh with its own material, first");
            return;
        }
        Material material = BodyMaterials.of(scene, active());
        SelectedBodies same = SelectedBodies.of(BodyEdits.movable(scene).stream()
                .filter(body -> BodyMaterials.has(scene, body)
                        && BodyMaterials.of(scene, body).equals(material))
                .toList());
        set(same.contains(active()) ? same.withActive(active()) : same);
        notice.accept(bodies.get().count() + " bodies of this material selected");
    }

    /** Removes bodies whose numbers have changed their meaning. */
    void follow(Scene before, Scene now) {
        // A poured sphere is no body of the scene; the others keep their numbers unless bodies were added or deleted.
        if (BodyEdits.haveOtherCounts(before, now) || BodyEdits.isPoured(before, active())) {
            set(bodies.get()
                    .where(body -> !BodyEdits.isRenumbered(before, now, body) && BodyEdits.isSelectable(now, body)));
        }
    }

    private boolean isMovable(int body) {
        return BodyEdits.isMovable(document.scene(), body);
    }

    private void set(SelectedBodies selected) {
        if (!selected.equals(bodies.get())) {
            // The next edit may have the same name, but edits other bodies.
            document.endGesture();
            bodies.set(selected);
            active.set(selected.active());
        }
    }
}
