/** The package's element for a script tag: no exports, no globals. */
import './hexlens'
