package dev.twister.gui.panel;

import dev.twister.gui.controls.Tooltips;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;

/** A section of the panel: a heading and rows. */
public final class PanelSection extends VBox {
    private static final PseudoClass FOLDED = PseudoClass.getPseudoClass("folded");

    private final String heading;
    private final Label label;
    private final VBox content;
    private Consumer<Boolean> whenFolded = _ -> {};

    /** A section of rows, and of what is below them. */
    PanelSection(String heading, List<PanelRow> rows, Node... below) {
        this(heading, Stream.concat(rows.stream(), Stream.of(below)).toArray(Node[]::new));
    }

    public PanelSection(String heading, Node... rows) {
        this.heading = heading;
        getStyleClass().add("section");
        label = new Label(heading);
        label.getStyleClass().add("heading");
        label.setMaxWidth(Double.MAX_VALUE);
        content = new VBox(rows);
        content.getStyleClass().add("rows");
        setVgrow(content, Priority.ALWAYS);
        getChildren().addAll(label, content);
    }

    String heading() {
        return heading;
    }

    /** Its rows, also those in parts of it, in their order. */
    Stream<PanelRow> rows() {
        return rows(content);
    }

    private static Stream<PanelRow> rows(Node node) {
        return switch (node) {
            case PanelRow row -> Stream.of(row);
            case VBox part -> part.getChildren().stream().flatMap(PanelSection::rows);
            default -> Stream.empty();
        };
    }

    /** Makes a click on the heading fold or unfold the rows. */
    void makeFoldable(boolean folded, Consumer<Boolean> changed) {
        label.getStyleClass().add("foldable");
        label.setTooltip(Tooltips.of("Folds or unfolds. The key of a row unfolds its section."));
        label.setOnMouseClicked(_ -> fold(!isFolded()));
        fold(folded);
        whenFolded = changed;
    }

    boolean isFolded() {
        return !content.isManaged();
    }

    void fold(boolean folded) {
        if (folded != isFolded() || label.getText().equals(heading)) {
            content.setVisible(!folded);
            content.setManaged(!folded);
            label.setText((folded ? "▸ " : "▾ ") + heading);
            pseudoClassStateChanged(FOLDED, folded);
            whenFolded.accept(folded);
        }
    }
}
