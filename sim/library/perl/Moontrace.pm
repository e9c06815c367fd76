package Moontrace;

# Pages of Moon and other tactile scripts from Perl: their surface, the force that a tip feels there,
# their letters and pictures. Calls libmoontrace.so.0 by FFI::Platypus; needs no compiler.
#
#   use Moontrace;
#   my $page = Moontrace->page('the moon', letter_size => 0.012);
#   my ($height, $slope_x, $slope_y) = $page->sample(0.02, 0.27);
#   my ($x, $y, $z) = $page->force(0.02, 0.27, -0.001);
#   print "$_->{sign} at $_->{x}\n" for $page->letters;
#   $page->draw('page.svg');
#
# Units are SI: metres and newtons. The origin is the page's lower left corner, x goes along the
# text, y up the page, z out of the paper; z = 0 is the flat paper. What the library refuses is died
# with, in one line.

use strict;
use warnings;
use Carp qw(croak);
use Encode qw(encode);
use FFI::Platypus 1.00;

our $VERSION = '0.1.0';

use constant INTERFACE => 1;

my $ffi = FFI::Platypus->new(api => 1, lib => $ENV{MOONTRACE_LIBRARY} // _beside() // 'libmoontrace.so.0');
$ffi->attach([moontrace_check => '_check'], ['uint32'] => 'int');
$ffi->attach([moontrace_message => '_message'], [] => 'string');
$ffi->attach([moontrace_version => 'version'], [] => 'string', sub { $_[0]->() });
$ffi->attach([moontrace_script_open => '_script_open'], ['string', 'string', 'opaque*'] => 'int');
$ffi->attach([moontrace_script_close => '_script_close'], ['opaque'] => 'int');
$ffi->attach([moontrace_text_open => '_text_open'], ['opaque', 'string', 'string', 'opaque*'] => 'int');
$ffi->attach([moontrace_text_close => '_text_close'], ['opaque'] => 'int');
$ffi->attach([moontrace_page_open => '_page_open'], ['opaque', 'size_t', 'opaque*'] => 'int');
$ffi->attach([moontrace_page_describe => '_page_describe'], ['opaque', 'string'] => 'int');
$ffi->attach([moontrace_page_letter => '_page_letter'], ['opaque', 'size_t', 'string'] => 'int');
$ffi->attach([moontrace_page_draw => '_page_draw'], ['opaque', 'string', 'uint32'] => 'int');
$ffi->attach([moontrace_page_close => '_page_close'], ['opaque'] => 'int');
$ffi->attach([moontrace_sample => '_sample'], ['opaque', 'double', 'double', 'double[3]'] => 'int');
$ffi->attach([moontrace_force => '_force'], ['opaque', 'opaque', 'double', 'double', 'double', 'double[3]'] => 'int');

_require(_check(INTERFACE));

# The library that was installed with this file, in any folder.
sub _beside {
  (my $prefix = __FILE__) =~ s{/share/perl5/Moontrace\.pm$}{} or return;
  my ($library) = glob "$prefix/lib/libmoontrace.so.0 $prefix/lib/*/libmoontrace.so.0";
  return defined $library && -e $library ? $library : undef;
}

sub _require {
  my ($answer) = @_;
  croak _message() if $answer != 0;
}

# The fields of moontrace_style, in their order.
my @flags = qw(embossed rules raised_margin structure);
my @numbers = qw(margin letter_size width depth rounding letter_gap word_gap line_pitch grade);
my @words = qw(h_form table only lines links hyphenation);

sub _style {
  my (%given) = @_;
  my %known = map { $_ => 1 } @flags, 'sheet', @numbers, @words;
  $known{$_} or croak "no such setting: $_" for sort keys %given;
  my @texts = map { defined $given{$_} ? encode('UTF-8', $given{$_}) : undef } 'sheet', @words;
  my $style = sub {
    pack 'L6 p d9 p6', $_[0], (map { $given{$_} ? 1 : 0 } @flags), 0, $texts[0],
      (map { $given{$_} // 0 } @numbers), @texts[1 .. 6];
  };
  # the words are kept beside the struct that points to them
  return ($style->(length $style->(0)), \@texts);
}

# The first page of a text, or that of the number `page`, in the script `script`.
sub page {
  my ($class, $words, %style) = @_;
  croak 'the text holds a character 0' if $words =~ /\0/;
  my ($script, $number) = (delete $style{script} // 'moon', delete $style{page} // 0);
  my ($style, $kept) = _style(%style);
  my ($script_handle, $text, $page);
  _require(_script_open($script, undef, \$script_handle));
  my $answer = _text_open($script_handle, encode('UTF-8', $words), $style, \$text);
  _script_close($script_handle);
  _require($answer);
  $answer = _page_open($text, $number, \$page);
  _text_close($text);
  _require($answer);
  return bless {handle => $page}, $class;
}

# A struct that the library fills, unpacked behind its size and a reserved field.
sub _facts {
  my ($format, $describe) = @_;
  my $room = pack 'L L x[' . $format . ']', 8 + length(pack 'x[' . $format . ']'), 0;
  _require($describe->($room));
  return unpack 'x8 ' . $format, $room;
}

# width, height [m], letters, lines, greatest_fall, greatest_rise [m], greatest_slope.
sub facts {
  my ($self) = @_;
  my %facts;
  @facts{qw(width height letters lines greatest_fall greatest_rise greatest_slope)} =
    _facts('ddQQddd', sub { _page_describe($self->{handle}, $_[0]) });
  return \%facts;
}

# Each with sign, x, y [m], line, word, source_begin, source_end (bytes of the text in UTF-8).
sub letters {
  my ($self) = @_;
  return map {
    my ($number, %letter) = ($_);
    @letter{qw(sign x y line word source_begin source_end)} =
      _facts('pddQQQQ', sub { _page_letter($self->{handle}, $number, $_[0]) });
    \%letter
  } 0 .. $self->facts->{letters} - 1;
}

# Displacement of the paper at a point [m], below zero in grooves, and its slopes along x and y.
sub sample {
  my ($self, $x, $y) = @_;
  my @sample = (0, 0, 0);
  _require(_sample($self->{handle}, $x, $y, \@sample));
  return @sample;
}

# The force on a tip at a point [N], zero outside the surface.
sub force {
  my ($self, $x, $y, $z) = @_;
  my @force = (0, 0, 0);
  _require(_force($self->{handle}, undef, $x, $y, $z, \@force));
  return @force;
}

# Draws the page in its true size, as .svg, .pdf or .png; `letters`: with small print.
sub draw {
  my ($self, $path, %how) = @_;
  _require(_page_draw($self->{handle}, $path, $how{letters} ? 1 : 0));
}

sub DESTROY {
  my ($self) = @_;
  _page_close($self->{handle}) if defined $self->{handle};
}

1;
