package dev.twister.denoise;

import com.google.auto.service.AutoService;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Looks for Open Image Denoise on this machine, and tries what it finds. */
@AutoService(DenoiserProvider.class)
public final class OidnProvider implements DenoiserProvider {
    private static final String NAME = "Open Image Denoise";

    /** How to get the library. */
    private static final String ADVICE = "install " + NAME + " by 'pip install pyoidn' or from"
            + " https://www.openimagedenoise.org, or let " + LibraryPlaces.VARIABLE + " name its library or folder";

    @Override
    public Optional<DenoiserOffer> offer() {
        return Optional.of(offer(LibraryPlaces.ofThisMachine()));
    }

    /** The library of a machine; the first one found that works. */
    static DenoiserOffer offer(LibraryPlaces places) {
        List<Path> files = places.files();
        Optional<String> refused = Optional.empty();
        for (Path file : files) {
            LibraryProbe.Result tried = LibraryProbe.of(file.toString());
            if (tried.obstacle().isEmpty()) {
                return working(file.toString(), tried.version());
            }
            refused = refused.or(() -> tried.obstacle().map(why -> file + " " + why));
        }
        Optional<String> name =
                places.names().stream().filter(_ -> places.named().isEmpty()).findFirst();
        if (name.isPresent()) {
            LibraryProbe.Result tried = LibraryProbe.of(name.get());
            if (tried.obstacle().isEmpty()) {
                return working(name.get(), tried.version());
            }
        }
        String found = refused.orElseGet(() -> places.named()
                .map(text -> LibraryPlaces.VARIABLE + " is " + text + ", but there is no " + NAME)
                .orElse(NAME + " is not installed"));
        return DenoiserOffer.impossible(NAME, found + "; " + ADVICE);
    }

    private static DenoiserOffer working(String place, String version) {
        return DenoiserOffer.working(NAME + " " + version + ": " + place, () -> LibraryProbe.open(place));
    }
}
