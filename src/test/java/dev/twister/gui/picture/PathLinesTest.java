package dev.twister.gui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.explain.PixelPath;
import dev.twister.gui.edit.Scenes;
import dev.twister.gui.picture.PathView.PathLines;
import dev.twister.gui.picture.PathView.PathLines.Kind;
import dev.twister.gui.picture.PathView.PathLines.Line;
import java.util.List;
import org.junit.jupiter.api.Test;

class PathLinesTest {
    private final List<Line> lines =
            PathLines.of(PixelPath.of(Scenes.input(Scenes.scene()), Scenes.WIDTH / 2, Scenes.HEIGHT / 2, 0));

    @Test
    void theViewRayEndsWhereTheReflectedOneBegins() {
        Line view = only(Kind.VIEW);
        Line reflected = lines.stream()
                .filter(line -> line.kind() == Kind.REFLECTED)
                .findFirst()
                .orElseThrow();

        assertThat(view.from()).isEqualTo(Scenes.scene().camera().position());
        assertThat(view.to().z()).isCloseTo(-1.5, within(0.01));
        assertThat(reflected.from().z()).isCloseTo(view.to().z(), within(1e-4));
    }

    @Test
    void eachShadowRayLeadsToTheLight() {
        assertThat(lines.stream().filter(line -> line.kind() == Kind.LIT || line.kind() == Kind.BLOCKED))
                .hasSizeGreaterThanOrEqualTo(8)
                .allSatisfy(line -> assertThat(line.to().y()).isCloseTo(6, within(1.0)));
    }

    private Line only(Kind kind) {
        List<Line> found = lines.stream().filter(line -> line.kind() == kind).toList();
        assertThat(found).hasSize(1);
        return found.getFirst();
    }
}
