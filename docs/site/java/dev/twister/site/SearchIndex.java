package dev.twister.site;

import java.util.List;
import java.util.stream.Collectors;
import tools.jackson.databind.json.JsonMapper;

/** Addresses, titles and words of the pages as a script, which also works without a server. */
final class SearchIndex {
    private SearchIndex() {}

    static String of(List<Page> pages) {
        JsonMapper mapper = new JsonMapper();
        return pages.stream()
                .map(page -> mapper.writeValueAsString(List.of(
                        page.address().toString().replace('\\', '/'),
                        page.title(),
                        page.text().replaceAll("\\s+", " "))))
                .collect(Collectors.joining(",\n", "const pages = [\n", "\n];\n"));
    }
}
