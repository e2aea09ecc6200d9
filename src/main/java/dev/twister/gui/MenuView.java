package dev.twister.gui;

import dev.twister.gui.bodies.BodyActions;
import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.Command.Group;
import dev.twister.gui.controls.CommandActions;
import dev.twister.gui.controls.Ids;
import dev.twister.gui.drawing.StagesAndViews;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.SceneHistory;
import dev.twister.gui.edit.TagEdits;
import dev.twister.gui.files.FileActions;
import dev.twister.gui.files.SettingsKeeper;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Shape;
import dev.twister.world.StageOrView;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.value.ObservableValue;
import javafx.scene.Scene;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.ToggleGroup;
import javafx.scene.input.KeyEvent;

/** The menus. */
final class MenuView extends MenuBar {
    private final Map<Command, MenuItem> items = new EnumMap<>(Command.class);
    private final Map<MenuItem, Character> letters = new HashMap<>();
    private final Menu recent = new Menu("Open recent");

    MenuView(
            Studio studio,
            SettingsKeeper settings,
            FileActions files,
            CommandActions actions,
            Consumer<Shape.Kind> insertShape) {
        for (Group group : Group.values()) {
            Menu menu = menu(group, actions);
            if (group == Group.VIEW) {
                menu.getItems().addFirst(shownMenu(studio));
            }
            if (group == Group.ADD) {
                menu.getItems().addAll(1, shapes(insertShape));
            }
            if (group == Group.SELECT) {
                List<MenuItem> edit = getMenus().getLast().getItems();
                edit.add(edit.indexOf(items.get(Command.HIDE)), menu);
            } else {
                getMenus().add(menu);
            }
        }
        recent.setId("recent");
        List<MenuItem> file = getMenus().getFirst().getItems();
        file.add(1 + file.indexOf(items.get(Command.OPEN)), recent);
        underline(getMenus());
        settings.settingsProperty().subscribe(kept -> showRecent(kept.get(WindowSettings.RECENT_SCENES), files));
        studio.document().editsProperty().subscribe(this::showEdits);
        studio.selection().bodiesProperty().subscribe(_ -> showDeletable(studio));
        studio.sceneProperty().subscribe(_ -> showDeletable(studio));
    }

    private void showDeletable(Studio studio) {
        int count =
                BodyEdits.deletable(studio.scene(), studio.selection().bodies()).count();
        items.get(Command.DELETE).setDisable(count == 0);
    }

    /** Says why a command does nothing whose key is pressed in the picture. */
    void explainKeys(Scene scene, Studio studio) {
        scene.addEventHandler(
                KeyEvent.KEY_PRESSED,
                event -> items.forEach((command, item) -> {
                    if (item.isDisable() && command.keys().match(event)) {
                        studio.notice(whyNot(command, studio));
                    }
                }));
    }

    private static String whyNot(Command command, Studio studio) {
        int selected = studio.selection().active();
        return switch (command) {
            case DELETE ->
                TagEdits.of(studio.scene(), selected).locked()
                        ? "A locked body can't be deleted"
                        : BodyEdits.isLight(studio.scene(), selected)
                                ? BodyActions.UNDELETED_LIGHT
                                : whyNotSolid(studio, selected);
            case UNDO -> "Nothing to undo";
            case REDO, REDO_ALSO -> "Nothing to redo";
            default -> command.label() + " is not possible now";
        };
    }

    private static String whyNotSolid(Studio studio, int selected) {
        return BodyEdits.isPoured(studio.scene(), selected)
                ? "A poured sphere can't be deleted"
                : "Nothing is selected";
    }

    /** Lets go of all it leads to: JavaFX keeps the items of a menu bar with accelerators for ever. */
    void dismantle() {
        getMenus().forEach(menu -> menu.getItems().clear());
        getMenus().clear();
    }

    /** Shows whether a recording is going on. */
    void showRecording(boolean recording) {
        show(Command.RECORD, recording ? "Stop recording" : Command.RECORD.label());
    }

    /** Marks what a command switches while that is on. */
    private static MenuItem checked(String label, ObservableValue<Boolean> on) {
        CheckMenuItem item = new CheckMenuItem(label);
        on.subscribe(item::setSelected);
        // A click on the item switches its mark, whatever the command has come to.
        item.selectedProperty().subscribe(_ -> item.setSelected(on.getValue()));
        return item;
    }

    private static Menu shownMenu(Studio studio) {
        Menu menu = new Menu("Show");
        menu.setId("menu-show");
        ToggleGroup group = new ToggleGroup();
        for (StageOrView picture : StagesAndViews.all()) {
            RadioMenuItem item = new RadioMenuItem(StagesAndViews.label(picture));
            item.setToggleGroup(group);
            item.setOnAction(_ -> studio.setShown(picture));
            studio.shownProperty().subscribe(shown -> item.setSelected(shown == picture));
            if (picture == StageOrView.ALBEDO) {
                menu.getItems().add(new SeparatorMenuItem());
            }
            menu.getItems().add(item);
        }
        return menu;
    }

    private static List<MenuItem> shapes(Consumer<Shape.Kind> insert) {
        List<MenuItem> shapes = new ArrayList<>();
        for (Shape.Kind kind : Shape.Kind.values()) {
            String name = Shape.of(kind, 1).name();
            MenuItem item = new MenuItem(name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1));
            item.setId("menu-insert-" + name);
            item.setOnAction(_ -> insert.accept(kind));
            shapes.add(item);
        }
        return shapes;
    }

    private Menu menu(Group group, CommandActions actions) {
        Menu menu = new Menu(group.label());
        for (Command command : Command.values()) {
            if (command.group() == group) {
                if (command.isBelowLine()) {
                    menu.getItems().add(new SeparatorMenuItem());
                }
                MenuItem item = actions.state(command)
                        .map(on -> checked(command.label(), on))
                        .orElseGet(() -> new MenuItem(command.label()));
                item.setId("menu-" + Ids.of(command.name().replace('_', ' ')));
                item.setAccelerator(command.keys());
                item.setOnAction(_ -> actions.run(command));
                item.setVisible(!command.isSecondKey());
                items.put(command, item);
                menu.getItems().add(item);
            }
        }
        return menu;
    }

    private void showRecent(List<String> files, FileActions actions) {
        recent.getItems()
                .setAll(files.stream()
                        .map(file -> {
                            MenuItem item = new MenuItem(file);
                            item.setMnemonicParsing(false);
                            item.setOnAction(_ -> actions.open(Path.of(file)));
                            return item;
                        })
                        .toList());
        recent.setDisable(files.isEmpty());
    }

    private void showEdits(SceneHistory.State state) {
        showEdit(Command.UNDO, state.undoable());
        showEdit(Command.REDO, state.redoable());
        showEdit(Command.REDO_ALSO, state.redoable());
    }

    private void showEdit(Command command, Optional<String> edit) {
        items.get(command).setDisable(edit.isEmpty());
        show(command, edit.map(what -> command.label() + ": " + what).orElse(command.label()));
    }

    /** Its letter stays underlined. */
    private void show(Command command, String text) {
        MenuItem item = items.get(command);
        item.setText(Mnemonics.marked(text, letters.getOrDefault(item, Mnemonics.NONE)));
    }

    /** Underlines a letter of each item, and of those of its menus. */
    private void underline(List<? extends MenuItem> menu) {
        List<MenuItem> named = menu.stream()
                .<MenuItem>map(item -> item)
                .filter(item -> item.isVisible() && !(item instanceof SeparatorMenuItem))
                .toList();
        List<Character> free =
                Mnemonics.letters(named.stream().map(MenuItem::getText).toList());
        for (int index = 0; index < named.size(); index++) {
            MenuItem item = named.get(index);
            letters.put(item, free.get(index));
            item.setText(Mnemonics.marked(item.getText(), free.get(index)));
            if (item instanceof Menu inner) {
                underline(inner.getItems());
            }
        }
    }
}
