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
            try {
                return working(file.toString());
            } catch (DenoiseException problem) {
                refused = refused.or(() -> Optional.of(file + " " + problem.getMessage()));
            }
        }
        Optional<String> name =
                places.names().stream().filter(_ -> places.named().isEmpty()).findFirst();
        if (name.isPresent()) {
            try {
                return working(name.get());
            } catch (DenoiseException _) {
                // A name that the loader does not know.
            }
        }
        String found = refused.orElseGet(() -> places.named()
                .map(text -> LibraryPlaces.VARIABLE + " is " + text + ", but there is no " + NAME)
                .orElse(NAME + " is not installed"));
        return DenoiserOffer.impossible(NAME, found + "; " + ADVICE);
    }

    /** @throws DenoiseException if the library does not work; the message continues its name */
    private static DenoiserOffer working(String place) {
        try (OpenImageDenoise tried = new OpenImageDenoise(place)) {
            return DenoiserOffer.working(NAME + " " + tried.text() + ": " + place, () -> opened(place));
        }
    }

    private static Denoiser opened(String place) {
        try {
            return new OpenImageDenoise(place);
        } catch (DenoiseException problem) {
            throw new DenoiseException(place + " " + problem.getMessage(), problem);
        }
    }
}
