package dev.twister.gui.camera;

import dev.twister.gui.controls.Ids;
import dev.twister.gui.edit.BodyTitles;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.property.TrackProperties;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.SequencedMap;
import java.util.Set;
import javafx.geometry.Point2D;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.layout.Region;

/** Asks of which property to set a keyframe: of the selected bodies, the lens, the sky or the picture. */
public final class KeyframeMenu {
    private static final List<String> PLACE = List.of("position", "rotation", "scale", "radius");

    private final Region picture;
    private final Studio studio;

    /** @param picture over which the menu opens */
    public KeyframeMenu(Region picture, Studio studio) {
        this.picture = picture;
        this.studio = studio;
    }

    /** Opens the menu over the middle of the picture. */
    public void show() {
        ContextMenu menu = new ContextMenu();
        menu.setId("keyframe-menu");
        List<TrackTarget> selected = selected();
        if (!selected.isEmpty()) {
            menu.getItems().add(item("Place and size", selected, PLACE));
            names(selected)
                    .forEach(name -> menu.getItems().add(item(BodyTitles.property(name), selected, List.of(name))));
            menu.getItems().add(new SeparatorMenuItem());
        }
        for (TrackTarget target : List.of(TrackTarget.CAMERA, TrackTarget.SKY)) {
            Menu more = new Menu(BodyTitles.of(studio.scene(), target));
            names(List.of(target))
                    .forEach(name ->
                            more.getItems().add(item(BodyTitles.property(name), List.of(target), List.of(name))));
            menu.getItems().add(more);
        }
        menu.getItems().add(item("Ambient light", List.of(TrackTarget.SHADING), List.of("ambient")));
        menu.getItems().add(item("Exposure", List.of(TrackTarget.RENDERING), List.of("exposure")));
        Point2D middle = picture.localToScreen(picture.getWidth() / 2, picture.getHeight() / 4);
        menu.show(picture, middle.getX(), middle.getY());
    }

    /** Deletes the keyframes of the selected bodies at the present time. */
    public void delete() {
        List<TrackTarget> selected = selected();
        if (selected.isEmpty()) {
            studio.notice("Select a body or a light to delete its keyframe");
        } else {
            studio.film().deleteKeyframes(selected);
        }
    }

    private List<TrackTarget> selected() {
        return studio.selection().bodies().bodies().stream()
                .flatMap(body -> BodyTitles.target(studio.scene(), body).stream())
                .toList();
    }

    private static List<String> names(List<TrackTarget> targets) {
        Set<String> names = new LinkedHashSet<>();
        targets.forEach(target -> TrackProperties.of(target).forEach(property -> names.add(property.name())));
        return new ArrayList<>(names);
    }

    private MenuItem item(String label, List<TrackTarget> targets, List<String> properties) {
        MenuItem item = new MenuItem(label);
        item.setId("keyframe-" + Ids.of(label));
        item.setOnAction(_ -> {
            SequencedMap<TrackTarget, List<String>> chosen = new LinkedHashMap<>();
            targets.forEach(target -> chosen.put(target, properties));
            studio.film().setKeyframes(chosen);
        });
        return item;
    }
}
