package dev.twister.gui.panel;

import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.BodyTitles;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.gui.edit.TagEdits;
import dev.twister.scene.Scene;
import dev.twister.scene.select.Tag;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A line of the list of bodies: a body, or the heading of a group.
 *
 * @param body {@link BodyNumber#NONE} of a heading
 * @param text the displayed name
 * @param tag of the body; of a heading its group, hidden and locked if all its bodies are
 * @param members the bodies of a heading's group; empty of a body
 */
public record OutlineLine(int body, String text, Tag tag, List<Integer> members) {
    /** The bodies without a group, then each group with its bodies, unless it is folded. */
    public static List<OutlineLine> of(Scene scene, SelectedBodies selected, Set<String> folded) {
        List<OutlineLine> lines = new ArrayList<>();
        Map<String, List<OutlineLine>> groups = new LinkedHashMap<>();
        for (int body : BodyTitles.listed(scene, selected)) {
            Tag tag = TagEdits.of(scene, body);
            OutlineLine line = new OutlineLine(body, BodyTitles.name(scene, body), tag, List.of());
            if (tag.group().isEmpty()) {
                lines.add(line);
            } else {
                groups.computeIfAbsent(tag.group(), _ -> new ArrayList<>()).add(line);
            }
        }
        groups.forEach((name, bodies) -> {
            lines.add(heading(name, bodies));
            lines.addAll(folded.contains(name) ? List.of() : bodies);
        });
        return lines;
    }

    private static OutlineLine heading(String name, List<OutlineLine> bodies) {
        Tag tag = new Tag(
                "",
                name,
                bodies.stream().allMatch(line -> line.tag().hidden()),
                bodies.stream().allMatch(line -> line.tag().locked()));
        return new OutlineLine(
                BodyNumber.NONE,
                name,
                tag,
                bodies.stream().map(OutlineLine::body).toList());
    }

    public boolean isHeading() {
        return !members.isEmpty();
    }

    /** Whether it stands under a heading. */
    public boolean isInGroup() {
        return !isHeading() && !tag.group().isEmpty();
    }

    /** What a change of the line changes: its body, or all of its group. */
    public List<Integer> bodies() {
        return isHeading() ? members : List.of(body);
    }
}
