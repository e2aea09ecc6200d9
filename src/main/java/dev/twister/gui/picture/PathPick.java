package dev.twister.gui.picture;

import dev.twister.explain.PixelPath;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.studio.Studio;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** The pixel whose path is shown. It stays as it was when it was picked, wherever the camera goes. */
public final class PathPick {
    private Optional<DrawnPicture> picked = Optional.empty();
    private final ReadOnlyObjectWrapper<Optional<PixelPath>> path = new ReadOnlyObjectWrapper<>(Optional.empty());

    public PathPick(Studio studio) {
        studio.document().originalProperty().subscribe(_ -> clear());
    }

    public ReadOnlyObjectProperty<Optional<PixelPath>> pathProperty() {
        return path.getReadOnlyProperty();
    }

    public boolean isShown() {
        return path.get().isPresent();
    }

    /** Shows the path through a pixel's center. */
    public void pick(DrawnPicture picture, int x, int y) {
        picked = Optional.of(picture);
        path.set(Optional.of(PixelPath.of(picture.input().withSamples(0, 1), x, y, 0)));
    }

    /** The scene's body that a step of the path meets. */
    public int sceneBody(int body) {
        return picked.map(picture -> picture.sceneBody(body)).orElse(body);
    }

    public void clear() {
        picked = Optional.empty();
        path.set(Optional.empty());
    }
}
