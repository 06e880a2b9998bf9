-- Lab 4.2. Längen in m, Zeiten in s, Geschwindigkeiten in m/s.

-- Läuft einmal, wenn die Szene aufgestellt ist.
-- Hierher gehört, womit die Kreise beginnen.
function on_load()
  -- Gib circle1 hier seine Geschwindigkeit.
end

-- Läuft in jedem Schritt; timestep ist seine Dauer.
-- Hierher gehört, wie sich die Kreise bewegen.
function on_update(timestep)
  -- Bewege circle1 hier: Sein neuer Ort ist der alte plus der
  -- Weg dieses Schritts.
end
